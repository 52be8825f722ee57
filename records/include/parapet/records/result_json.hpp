/// A simulation's result as result.json and series.csv.
#pragma once

#include <string>
#include <vector>

#include "parapet/designs/case_spec.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::records {

/// {key: value or null} of every metric, in the result's order.
designs::Json metrics_json(const solver::Result& result);

/// {key: why there is no value} of the metrics without one.
designs::Json metrics_absent_json(const solver::Result& result);

/// {key: "run_too_short" or "too_coarse"} of the metrics that a longer or finer run would bring.
designs::Json metrics_unknown_json(const std::vector<solver::Metric>& metrics);

/// {energy_gain_ratio, density_error_max, ...}: see solver::Quality.
designs::Json quality_json(const solver::Quality& quality);

/// [{key, value, limit, text}] of what is outside the limits.
designs::Json warnings_json(const std::vector<solver::Warning>& warnings);

/// Reads that list; null: none.
std::vector<solver::Warning> warnings_from_json(const designs::Json& json);

/// {key: {expanded_95, discretisation, ...}} of the metrics that carry an uncertainty, in the unit
/// of the metric (see solver::MetricUncertainty).
designs::Json uncertainty_json(const solver::Result& result);

/// {columns: [...], rows: [[...]]}; null where a value is not defined.
designs::Json series_json(const solver::Series& series);

/// One header line of column keys, then one line per sample; the shortest digits that give the
/// same double back, nothing where a value is not defined.
std::string series_csv(const solver::Series& series);

/// [{barrier, part, window_end_s, window_s, normal_force_n_per_m, edge_m, pressure_pa}] of each
/// stem and deflector: see solver::LoadProfile.
designs::Json load_profiles_json(const solver::Result& result);

/// The same as pressure.csv: a row for each strip.
std::string load_profiles_csv(const solver::Result& result);

/// The content of result.json, format "parapet-result/1". Only `timing` may differ between two
/// runs of the same case.
/// @param resolved the case with every default written out
/// @param provenance of provenance_json
/// @param threads the run used; goes into `timing`
designs::Json result_json(const std::string& name, const solver::Result& result,
                          const designs::Json& resolved, const designs::Json& provenance,
                          int threads);

/// Indented by two, with a line end: how every JSON file of Parapet looks.
std::string json_text(const designs::Json& json);

/// The shortest decimal digits that give the same double back.
std::string shortest_number(double value);

}  // namespace parapet::records
