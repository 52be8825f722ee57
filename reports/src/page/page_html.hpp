/// The page as one HTML file: data, blocks of bytes, and the program that shows them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "parapet/designs/case_spec.hpp"
#include "parapet/reports/page.hpp"

namespace parapet::reports {

/// Bytes that the page's program asks for by name.
struct PageBlock {
  std::string id;
  std::string base64;
};

/// Bytes as a block.
PageBlock page_block(std::string id, std::string_view bytes);

/// What of a provenance says by which program the results were simulated, which need not be the one
/// that writes the page; null where the provenance does not say.
designs::Json simulated_by(const designs::Json& provenance);

/// What every page has: format, kind, name, date, program and so on; `keys` and `runs` empty.
designs::Json common_json(const std::string& kind, const std::string& name, const std::string& hash,
                          const PageOptions& options);

/// Adds a key to `keys`: words, unit, and the definition of a metric.
void add_key(designs::Json& page, const std::string& key);

/// Adds a command that repeats something.
void add_command(designs::Json& page, const std::string& what, const std::string& command);

/// The HTML. Every `<` of the data is written as \u003c: no string ends the element that holds it.
std::string page_html(const designs::Json& page, const std::vector<PageBlock>& blocks);

/// A path as a shell takes it.
std::string shell_word(const std::string& text);

}  // namespace parapet::reports
