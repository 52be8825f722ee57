#include <array>
#include <cstdint>

#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {

std::string spec_hash(const Json& json) {
  // FNV-1a, 64 bits: offset basis and prime of its authors.
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : json.dump()) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211ULL;
  }
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 0; i < text.size(); ++i) {
    text[text.size() - 1 - i] = digits[(hash >> (4 * i)) & 0xF];
  }
  return text;
}

}  // namespace parapet::designs
