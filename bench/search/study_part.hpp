// What the comparison needs of a study: its variables and the limits that need no simulation.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace parapet::bench::search {

// lower <= expression <= upper; the violation is divided by |limit|, or 1 if that is 0.
struct ExpressionLimit {
  std::string expression;
  std::optional<double> lower, upper;
};

// c [n_limits] <= 0 allows a design; empty if there are no limits.
std::function<std::vector<double>(const std::vector<double>& x)> cheap_constraints(
    const std::vector<std::string>& variables, const std::vector<ExpressionLimit>& limits);

struct StudyPart {
  std::string name;
  std::vector<std::string> variables;
  std::vector<double> lower, upper;  // [d]
  std::vector<ExpressionLimit> limits;
};

// Those of an array of constraints that have an expression.
std::vector<ExpressionLimit> read_expression_limits(const nlohmann::ordered_json& constraints);

// @throws std::invalid_argument for a file that cannot be read or is no study.
StudyPart read_study_part(const std::filesystem::path& file);

}  // namespace parapet::bench::search
