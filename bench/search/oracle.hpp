// A table of simulations, interpolated: what every search method is given in place of the solver.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "radial_fit.hpp"

namespace parapet::bench::search {

// One simulation of the table.
struct TableRow {
  std::vector<double> u;  // [d] in the unit cube
  bool ok = false;
  std::map<std::string, std::optional<double>>
      metrics;            // no value: nothing overflowed, for example
  double cpu_time = 0.0;  // [s]
};

// What is known of one metric.
struct MetricSurface {
  RadialFit fit;
  double least, greatest;  // physical bounds: values are clipped to them
  // Above 0 where the metric has a value; none if it has one everywhere.
  std::optional<RadialSurface> presence;
  double presence_errors = 0.0;  // share of the designs that leave-one-out puts on the wrong side
};

struct Oracle {
  std::string name;
  std::vector<std::string> variables;
  std::vector<double> lower, upper;  // [d]
  double median_cpu_time = 0.0;      // of one simulation [s]
  Eigen::MatrixXd designs;           // [n, d] of the simulations that came to an end
  std::vector<std::vector<double>> failed;
  std::map<std::string, MetricSurface> metrics;

  // False where the nearest simulation of the table failed.
  bool succeeds(const std::vector<double>& x) const;

  // Value at x [d] in the variables' units; empty where the metric has none.
  std::optional<double> smooth(const std::string& metric, const std::vector<double>& x) const;

  // The same with the metric's noise, which belongs to the design and repeats.
  std::optional<double> noisy(const std::string& metric, const std::vector<double>& x) const;

  std::vector<double> to_unit(const std::vector<double>& x) const;
};

inline constexpr int design_digits = 6, weight_digits = 9;  // of the numbers in a table's file
double rounded(double value, int digits);                   // to so many significant digits

// Fits every metric named. Designs are rounded first as they will be written: weights fitted to
// others would give other values once read back. @throws std::invalid_argument for a metric that
// too few rows have.
Oracle fit_oracle(const std::string& name, const std::vector<std::string>& variables,
                  const std::vector<double>& lower, const std::vector<double>& upper,
                  const std::vector<TableRow>& rows, const std::vector<std::string>& metrics);

nlohmann::ordered_json to_json(const Oracle& oracle);
Oracle oracle_from_json(const nlohmann::ordered_json& json);
Oracle read_oracle(const std::filesystem::path& file);

}  // namespace parapet::bench::search
