// Pages and measured data that travel inside the library.
#pragma once

#include <span>
#include <string_view>

namespace parapet::validation {

struct EmbeddedFile {
  const char* name;
  const char* text;
};

std::span<const EmbeddedFile> embedded_files();

// Text of a file of validation/pages or validation/data. Throws std::invalid_argument.
std::string_view embedded_text(std::string_view name);

}  // namespace parapet::validation
