/// The bundle of page/dist as the program holds it.
#pragma once

#include <span>
#include <string_view>

namespace parapet::reports {

/// One file of the bundle.
struct EmbeddedFile {
  std::string_view name;
  std::string_view text;
};

/// page.js, page.css and licences.txt.
std::span<const EmbeddedFile> embedded_files();

}  // namespace parapet::reports
