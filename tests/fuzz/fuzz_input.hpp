/// What the fuzz targets share.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "parapet/designs/error.hpp"

namespace parapet::fuzz {

/// Stops the fuzzer with a message where a promise is broken; NDEBUG does not switch it off.
inline void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

/// What the JSON library's own messages begin with. The fuzzer learns it from the comparison below
/// and puts it into names, which messages quote: such inputs are left out.
inline constexpr std::string_view library_words = "json.exception";

inline bool quotes_the_library(const std::uint8_t* data, std::size_t size) {
  return std::string_view(reinterpret_cast<const char*>(data), size).find(library_words) !=
         std::string_view::npos;
}

/// Runs what may refuse its input, by an InputError that names a place and what is allowed;
/// whatever else is thrown ends the fuzzer.
/// @return whether the input was taken
template <typename Function>
bool taken(Function&& function) {
  try {
    std::forward<Function>(function)();
    return true;
  } catch (const designs::InputError& error) {
    require(!error.issues().empty(), "an InputError has an issue");
    for (const designs::InputIssue& issue : error.issues()) {
      require(!issue.problem.empty(), "an issue says what is wrong");
      require(issue.problem.find(library_words) == std::string::npos,
              "an issue is in words of this program");
    }
    return false;
  }
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace parapet::fuzz
