/// sensitivity.json: which variables the metrics of a study depend on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "parapet/designs/study_spec.hpp"

namespace parapet::study {

/// A Sobol' index, a share of the metric's variance, with its 95 % interval.
struct SobolIndex {
  double value = 0.0;
  double lower_95 = 0.0, upper_95 = 0.0;
};

/// A variable's value, or the name of a choice's option.
using VariablePlace = std::variant<double, std::string>;

/// The metric's average over everything else, along one variable; in the metric's unit.
struct MainEffect {
  std::vector<VariablePlace> at;  ///< [n]
  std::vector<double> mean;       ///< [n]
  std::vector<double> lower_95;   ///< [n]
  std::vector<double> upper_95;   ///< [n]
};

/// What one variable does to a metric.
struct VariableSensitivity {
  std::string name;
  SobolIndex first;  ///< what the variable explains alone
  SobolIndex total;  ///< with all its interactions
  MainEffect main_effect;
};

/// What the variables do to one metric.
struct MetricSensitivity {
  std::string name;    ///< of the modelled quantity, for example "launch_length_m (highest value)"
  std::string metric;  ///< its metric
  std::string statistic;  ///< over the scenarios, in words; empty where there is one event
  int designs = 0;        ///< that the surrogate has seen
  std::optional<double> q_squared;  ///< of the surrogate, leave-one-out
  bool varies = false;              ///< over the box at all
  std::vector<VariableSensitivity> variables;
};

/// The content of sensitivity.json as types.
struct Sensitivity {
  std::string study_name, spec_hash;
  std::string source;  ///< of the surrogates: surrogates.json or evaluations.jsonl
  std::string domain;  ///< in words
  int realisations = 0, base_points = 0;
  std::vector<MetricSensitivity> metrics;
};

/// The content of sensitivity.json, format "parapet-sensitivity/1".
designs::Json to_json(const Sensitivity& sensitivity);

/// Reads such a file. Empty when it is missing, not whole, or of another study.
std::optional<Sensitivity> read_sensitivity(const std::filesystem::path& file,
                                            const std::string& spec_hash);

}  // namespace parapet::study
