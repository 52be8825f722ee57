#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "key_text.hpp"
#include "recommendation_parts.hpp"
#include "response_fit.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

/// Metrics of the objectives, then of the constraints, each once.
std::vector<std::string> asked_metrics(const StudyLog& log) {
  std::vector<std::string> keys;
  const auto add = [&](const std::string& key) {
    if (!key.empty() && std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  };
  for (const LoggedDesign& design : log.designs) {
    for (const LoggedObjective& objective : design.objectives) {
      if (objective.on_metric) add(objective.of);
    }
  }
  for (const LoggedDesign& design : log.designs) {
    for (const LoggedConstraint& constraint : design.constraints) {
      if (constraint.on_metric) add(constraint.of);
    }
  }
  return keys;
}

/// One sentence on a variable, no stronger than the data.
std::string sentence(const VariableEffect& effect, const ResponseFit& fit,
                     const std::string& metric, const std::string& variable) {
  if (effect.tried_from == effect.tried_to) return "was not varied";
  if (fit.model == ResponseModel::none || !effect.change) return "the data cannot tell";
  if (fit.r2_left_out < rough_r2) return "the data cannot tell (the fit does not predict)";
  std::string words;
  if (effect.change_clear) {
    words =
        fmt::format("{} by {} ± {} from {} to {}", *effect.change > 0.0 ? "rises" : "falls",
                    number_text(std::abs(*effect.change)), with_unit(effect.standard_error, metric),
                    with_unit(effect.tried_from, variable), with_unit(effect.tried_to, variable));
  }
  if (effect.bend_clear) {
    words += words.empty() ? "" : "; ";
    words += effect.bend > 0.0 ? "lowest inside the range tried, or flattening there"
                               : "highest inside the range tried, or flattening there";
  }
  if (words.empty()) words = "no effect that the data can tell from the scatter";
  return words;
}

std::string verdict(const ResponseFit& fit) {
  if (fit.model == ResponseModel::none) return fmt::format("no fit: {}", fit.why_none);
  if (fit.r2_left_out >= trusted_r2) return "the fit predicts designs left out of it well";
  if (fit.r2_left_out >= rough_r2) {
    return "the fit predicts designs left out of it only roughly; read it as a trend";
  }
  return "the fit does not predict designs left out of it: the data cannot tell what the variables "
         "do";
}

Json fit_json(const StudyLog& log, const std::string& metric) {
  std::vector<std::vector<double>> x;
  std::vector<double> y;
  for (const LoggedDesign& design : log.designs) {
    const std::optional<double> value = log.counts(design) ? design.metric(metric) : std::nullopt;
    if (!value || !std::isfinite(*value)) continue;
    std::vector<double> row;
    for (const LoggedVariable& variable : log.variables) {
      row.push_back(design.design.at(variable.name));
    }
    x.push_back(std::move(row));
    y.push_back(*value);
  }
  const ResponseFit fit = fit_response(x, y);
  const bool fitted = fit.model != ResponseModel::none;
  Json json{{"metric", metric},
            {"points", fit.points},
            {"model", to_string(fit.model)},
            {"r2", fitted ? Json(fit.r2) : Json(nullptr)},
            {"r2_left_out", fitted ? Json(fit.r2_left_out) : Json(nullptr)},
            {"scatter", fitted ? Json(fit.scatter) : Json(nullptr)},
            {"verdict", verdict(fit)},
            {"variables", Json::object()}};
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    const VariableEffect& effect = fit.effects[k];
    const std::string& name = log.variables[k].name;
    json["variables"][name] = {
        {"tried_from", effect.tried_from},
        {"tried_to", effect.tried_to},
        {"change", effect.change ? Json(*effect.change) : Json(nullptr)},
        {"standard_error", effect.change ? Json(effect.standard_error) : Json(nullptr)},
        {"standardised_effect", effect.change ? Json(effect.standardised) : Json(nullptr)},
        {"bend", effect.change ? Json(effect.bend) : Json(nullptr)},
        {"clear", effect.change_clear || effect.bend_clear},
        {"correlation", effect.correlation ? Json(*effect.correlation) : Json(nullptr)},
        {"says", sentence(effect, fit, metric, name)}};
  }
  return json;
}

}  // namespace

Json effects_json(const StudyLog& log) {
  Json list = Json::array();
  for (const std::string& metric : asked_metrics(log)) list.push_back(fit_json(log, metric));
  return list;
}

}  // namespace parapet::reports
