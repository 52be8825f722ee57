#include "parapet/records/file_name.hpp"

#include "parapet/records/checksum.hpp"

namespace parapet::records {

std::string file_name_of_0_1_0(const std::string& name) {
  std::string text = name;
  for (char& c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_' || c == '.';
    if (!plain) c = '_';
  }
  if (text.starts_with('.')) text.insert(text.begin(), '_');
  return text;
}

std::string file_name(const std::string& name) {
  const std::string text = file_name_of_0_1_0(name);
  return text == name ? text : text + "-" + sha256(name).substr(0, 8);
}

}  // namespace parapet::records
