#include "study_part.hpp"

#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "parapet/designs/study_spec.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

double scale_of(const ExpressionLimit& limit) {
  const double value = limit.upper ? *limit.upper : limit.lower.value_or(0.0);
  return value == 0.0 ? 1.0 : std::abs(value);
}

std::optional<double> number(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

}  // namespace

std::vector<ExpressionLimit> read_expression_limits(const Json& constraints) {
  std::vector<ExpressionLimit> limits;
  for (const Json& c : constraints) {
    if (!c.contains("expression")) continue;
    limits.push_back({c.at("expression"), number(c, "lower"), number(c, "upper")});
  }
  return limits;
}

std::function<std::vector<double>(const std::vector<double>& x)> cheap_constraints(
    const std::vector<std::string>& variables, const std::vector<ExpressionLimit>& limits) {
  if (limits.empty()) return nullptr;
  return [limits, variables](const std::vector<double>& x) {
    designs::Design design;
    for (std::size_t j = 0; j < x.size(); ++j) design[variables[j]] = x[j];
    std::vector<double> violations;
    for (const ExpressionLimit& limit : limits) {
      const double value = designs::evaluate_expression(limit.expression, design);
      if (limit.upper) violations.push_back((value - *limit.upper) / scale_of(limit));
      if (limit.lower) violations.push_back((*limit.lower - value) / scale_of(limit));
    }
    return violations;
  };
}

StudyPart read_study_part(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::invalid_argument("cannot read " + file.string());
  const Json study = Json::parse(in);
  if (study.value("format", "") != "parapet-study/1") {
    throw std::invalid_argument(file.string() + " is not a study (parapet-study/1)");
  }
  StudyPart part;
  part.name = study.at("name");
  for (const auto& [name, variable] : study.at("variables").items()) {
    part.variables.push_back(name);
    part.lower.push_back(variable.at("lower"));
    part.upper.push_back(variable.at("upper"));
  }
  part.limits = read_expression_limits(study.value("constraints", Json::array()));
  return part;
}

}  // namespace parapet::bench::search
