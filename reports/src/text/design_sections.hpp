/// Sections on the design that is shown.
#pragma once

#include <string>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

std::string variables_section(const DesignReport& design);

/// Empty without constraints.
std::string margins_section(const DesignReport& design);

/// The launch length against the formula that engineers use; empty where either is missing.
std::string hand_formula_section(const DesignReport& design);

/// The loads against the hand formulas; empty where no undisturbed flow is known.
std::string load_formulas_section(const DesignReport& design);

/// Every metric, with what it means.
/// @param definitions metric key, what it means
std::string metrics_section(const DesignReport& design,
                            const std::vector<std::pair<std::string, std::string>>& definitions);

}  // namespace parapet::reports
