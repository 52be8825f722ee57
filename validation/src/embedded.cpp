#include "embedded.hpp"

#include <stdexcept>
#include <string>

namespace parapet::validation {

std::string_view embedded_text(std::string_view name) {
  for (const EmbeddedFile& file : embedded_files()) {
    if (name == file.name) return file.text;
  }
  throw std::invalid_argument("the program holds no file \"" + std::string(name) + "\"");
}

}  // namespace parapet::validation
