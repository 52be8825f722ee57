/// Whole numbers in files that a stranger may have written.
#pragma once

#include <concepts>
#include <cstdint>
#include <utility>
#include <vector>

#include "parapet/designs/case_spec.hpp"

namespace parapet::records {

/// The number. JSON's own conversion is undefined where a number does not fit.
/// @throws designs::Json::type_error for anything else than a whole number in the type's range
template <std::integral Integer>
Integer whole_number(const designs::Json& json) {
  if (json.is_number_unsigned()) {
    const auto number = json.get<std::uint64_t>();
    if (std::in_range<Integer>(number)) return static_cast<Integer>(number);
  } else if (json.is_number_integer()) {
    const auto number = json.get<std::int64_t>();
    if (std::in_range<Integer>(number)) return static_cast<Integer>(number);
  }
  throw designs::Json::type_error::create(302, json.dump() + " is no whole number that fits",
                                          &json);
}

/// A list of them; throws the same.
template <std::integral Integer>
std::vector<Integer> whole_numbers(const designs::Json& json) {
  std::vector<Integer> numbers;
  for (const designs::Json& one : json) numbers.push_back(whole_number<Integer>(one));
  return numbers;
}

}  // namespace parapet::records
