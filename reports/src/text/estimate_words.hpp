#pragma once

#include <optional>
#include <string>

#include "parapet/study/expected.hpp"

namespace parapet::reports {

/// "0.091 ± 0.017 m", or "0.998 (0.991 to 1)" where a possible value ends the interval; "0.95 (one
/// run: its uncertainty is not known)"; "-" without an estimate. The uncertainty has two digits.
/// @param key whose suffix is the unit; empty: none
std::string estimate_words(const study::Expectation& expectation, const std::string& key);

/// "98 %", "more than 99.9 %"; "not known".
std::string probability_words(const std::optional<double>& probability);

}  // namespace parapet::reports
