#include "parapet/study/sweep_result.hpp"

#include <cmath>

#include "parapet/solver/metric_catalog.hpp"

namespace parapet::study {
namespace {

using designs::Json;

std::optional<double> number(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

Json optional_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

/// Metrics flat into the row, in the catalogue's order, then any others.
void put_metrics(Json& json, const records::SweepRowResult& row) {
  constexpr int any_barriers = 9;
  for (const solver::MetricInfo& info : solver::metric_catalog(any_barriers)) {
    const auto found = row.metrics.find(info.key);
    if (found != row.metrics.end()) json[info.key] = optional_number(found->second);
  }
  for (const auto& [key, value] : row.metrics) {
    if (!json.contains(key)) json[key] = optional_number(value);
  }
}

Json agreement_json(const records::SweepRowResult& row) {
  Json json = Json::object();
  for (const auto& [key, entry] : row.published.items()) {
    if (!entry.is_object()) continue;
    const std::optional<double> value = row.metric(key);
    const Agreement agreement = compare(value, entry);
    if (agreement.verdict == Agreement::Verdict::none) continue;
    const bool agrees = agreement.verdict == Agreement::Verdict::agrees;
    json[key] = {{"verdict", agrees ? "agrees" : "misses"},
                 {"distance", value ? Json(agreement.distance) : Json(nullptr)}};
  }
  return json;
}

Json row_json(const records::SweepRowResult& row) {
  Json json{{"id", row.id},
            {"description", row.description},
            {"status", std::string(solver::to_string(row.status))},
            {"reason", row.reason}};
  put_metrics(json, row);
  json["metrics_absent"] = row.metrics_absent.empty() ? Json::object() : Json(row.metrics_absent);
  json["steps"] = row.steps;
  json["simulated_time_s"] = row.stop_time;
  json["stop_reason"] = row.stop_reason;
  json["wall_time_s"] = row.wall_time;
  json["paper"] = row.published;
  if (row.published.is_object()) json["agreement"] = agreement_json(row);
  return json;
}

}  // namespace

Agreement compare(const std::optional<double>& computed, const designs::Json& published) {
  Agreement agreement;
  if (!published.is_object()) return agreement;
  agreement.published = number(published, "value");
  agreement.lower = number(published, "lower");
  agreement.upper = number(published, "upper");
  if (!agreement.lower && !agreement.upper) return agreement;
  agreement.verdict = Agreement::Verdict::misses;
  if (!computed) return agreement;
  if (agreement.lower && *computed < *agreement.lower) {
    agreement.distance = *computed - *agreement.lower;
  } else if (agreement.upper && *computed > *agreement.upper) {
    agreement.distance = *computed - *agreement.upper;
  } else if (std::isfinite(*computed)) {
    agreement.verdict = Agreement::Verdict::agrees;
  }
  return agreement;
}

designs::Json sweep_json(const std::string& name, const std::string& source, double spacing,
                         const std::vector<records::SweepRowResult>& rows,
                         const designs::Json& provenance) {
  Json json{{"format", "parapet-sweep-result/1"},
            {"name", name},
            {"source", source},
            {"spacing_m", spacing},
            {"rows", Json::array()}};
  for (const records::SweepRowResult& row : rows) json["rows"].push_back(row_json(row));
  if (!provenance.is_null()) json["provenance"] = provenance;
  return json;
}

}  // namespace parapet::study
