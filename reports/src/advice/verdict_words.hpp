#pragma once

#include <string>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// Below this probability a confirmed design is called so narrowly.
constexpr double sure_probability = 0.95;

/// "confirmed", "narrow", "untested" or "refuted": of advice that recommends a design.
std::string verdict_word(const Recommendation& advice);

/// The verdict in one or two sentences, no stronger than what was put to the test.
std::string verdict_words(const Recommendation& advice);

/// How likely a repeat meets the limits, in one line.
std::string limits_words(const Recommendation& advice);

}  // namespace parapet::reports
