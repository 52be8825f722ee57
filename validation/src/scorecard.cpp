#include "parapet/validation/scorecard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace parapet::validation {
namespace {

using Json = nlohmann::ordered_json;

// Six significant digits: what a reader can use, and the same on every machine.
Json number_json(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::stod(fmt::format("{:.6g}", value));
}

std::optional<double> optional_number(const Json& json, const char* key) {
  if (!json.contains(key) || json.at(key).is_null()) return std::nullopt;
  return json.at(key).get<double>();
}

std::string optional_text(const Json& json, const char* key) {
  return json.contains(key) ? json.at(key).get<std::string>() : std::string();
}

Measure measure_from_json(const Json& json) {
  Measure m;
  m.key = json.at("key").get<std::string>();
  m.what = json.at("what").get<std::string>();
  m.value = optional_number(json, "value").value_or(std::numeric_limits<double>::quiet_NaN());
  m.unit = optional_text(json, "unit");
  m.lower = optional_number(json, "lower");
  m.upper = optional_number(json, "upper");
  m.reason = optional_text(json, "reason");
  m.explanation = optional_text(json, "explanation");
  m.fitted = json.value("fitted", false);
  return m;
}

}  // namespace

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::met:
      return "met";
    case Verdict::fitted:
      return "fitted";
    case Verdict::missed:
      return "missed";
    default:
      return "measured";
  }
}

Verdict Measure::verdict() const {
  if (!lower && !upper) return Verdict::measured;
  const bool good =
      std::isfinite(value) && (!lower || value >= *lower) && (!upper || value <= *upper);
  if (!good) return Verdict::missed;
  return fitted ? Verdict::fitted : Verdict::met;
}

int Scorecard::count(Verdict verdict) const {
  return static_cast<int>(std::ranges::count_if(
      measures, [&](const Measure& measure) { return measure.verdict() == verdict; }));
}

const Measure* Scorecard::find(const std::string& key) const {
  const auto found = std::ranges::find(measures, key, &Measure::key);
  return found == measures.end() ? nullptr : &*found;
}

std::string value_text(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "none";
  std::string text = fmt::format("{:.4g}", value);
  const double size = std::abs(value);
  if (size >= 1e4 && size < 1e7) text = fmt::format("{:.0f}", value);
  return unit.empty() ? text : text + " " + unit;
}

std::string limit_text(const Measure& m) {
  if (m.lower && m.upper) return value_text(*m.lower, "") + " to " + value_text(*m.upper, m.unit);
  if (m.upper) return "at most " + value_text(*m.upper, m.unit);
  if (m.lower) return "at least " + value_text(*m.lower, m.unit);
  return "";
}

Json to_json(const Scorecard& card) {
  Json json;
  json["case"] = card.name;
  json["title"] = card.title;
  json["suite"] = card.full ? "full" : "quick";
  if (!card.failure.empty()) json["failure"] = card.failure;
  json["measures"] = Json::array();
  for (const Measure& m : card.measures) {
    Json row;
    row["key"] = m.key;
    row["what"] = m.what;
    row["value"] = number_json(m.value);
    if (!m.unit.empty()) row["unit"] = m.unit;
    if (m.lower) row["lower"] = number_json(*m.lower);
    if (m.upper) row["upper"] = number_json(*m.upper);
    if (m.fitted) row["fitted"] = true;
    row["verdict"] = to_string(m.verdict());
    if (!m.reason.empty()) row["reason"] = m.reason;
    if (!m.explanation.empty()) row["explanation"] = m.explanation;
    json["measures"].push_back(std::move(row));
  }
  json["figures"] = card.figures;
  return json;
}

Scorecard scorecard_from_json(const Json& json) {
  try {
    Scorecard card;
    card.name = json.at("case").get<std::string>();
    card.title = json.at("title").get<std::string>();
    card.full = json.at("suite") == "full";
    card.failure = optional_text(json, "failure");
    for (const Json& row : json.at("measures")) card.measures.push_back(measure_from_json(row));
    card.figures = json.at("figures").get<std::vector<std::string>>();
    return card;
  } catch (const Json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace parapet::validation
