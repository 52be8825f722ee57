#include "emulator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "hash_noise.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

constexpr double all_retained =
    0.986;  // above it one run of the tables in two hundred has a launch

struct Row {
  Design x;
  double spacing = 0.0, steps = 0.0;
  std::map<std::string, std::optional<double>> metrics;
};

std::vector<Row> read_rows(const std::filesystem::path& file,
                           const std::vector<std::string>& variables) {
  std::ifstream in(file);
  if (!in) throw std::invalid_argument("cannot read " + file.string());
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    const Json json = Json::parse(line);
    Row row;
    for (const std::string& name : variables) row.x.push_back(json.at("design").at(name));
    row.spacing = json.at("spacing_m");
    row.steps = json.at("particle_steps");
    for (const auto& [name, value] : json.at("metrics").items()) {
      if (value.is_number()) row.metrics[name] = value.get<double>();
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

Emulator::Emulator(const std::filesystem::path& file, const std::vector<std::string>& variables,
                   const std::vector<double>& lower, const std::vector<double>& upper,
                   const std::vector<std::string>& metrics, const std::string& overflow_metric,
                   const std::vector<double>& spacings)
    : lower_(lower), upper_(upper), overflow_metric_(overflow_metric) {
  const std::vector<Row> rows = read_rows(file, variables);
  for (const Row& row : rows) file_spacings_.push_back(row.spacing);
  std::sort(file_spacings_.begin(), file_spacings_.end());
  file_spacings_.erase(std::unique(file_spacings_.begin(), file_spacings_.end()),
                       file_spacings_.end());
  const auto place = [&](double spacing) {
    const auto found = std::find(file_spacings_.begin(), file_spacings_.end(), spacing);
    if (found == file_spacings_.end()) {
      throw std::invalid_argument(fmt::format("{} has no run of {:g} m", file.string(), spacing));
    }
    return static_cast<std::size_t>(found - file_spacings_.begin());
  };
  std::vector<double> steps(file_spacings_.size(), 0.0);
  runs_.assign(file_spacings_.size(), 0);
  for (const Row& row : rows) {
    steps[place(row.spacing)] += row.steps;
    ++runs_[place(row.spacing)];
  }
  for (const double spacing : spacings) {
    level_of_file_.push_back(place(spacing));
    steps_.push_back(steps[level_of_file_.back()] / runs_[level_of_file_.back()]);
  }
  surrogate::Layout layout;
  layout.n_levels = static_cast<int>(file_spacings_.size());
  for (std::size_t j = 0; j < variables.size(); ++j) layout.group.push_back(static_cast<int>(j));
  std::vector<std::string> modelled = metrics;
  if (std::find(metrics.begin(), metrics.end(), overflow_metric) == metrics.end()) {
    modelled.push_back(overflow_metric);
  }
  for (const std::string& metric : modelled) {
    surrogate::Data data;
    std::vector<double> values;
    std::vector<std::vector<double>> inputs;
    for (const Row& row : rows) {
      const auto found = row.metrics.find(metric);
      if (found == row.metrics.end()) continue;
      values.push_back(*found->second);
      inputs.push_back(unit(row.x));
      data.levels.push_back(static_cast<int>(place(row.spacing)));
    }
    data.values =
        Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    data.inputs.resize(data.values.size(), static_cast<Eigen::Index>(variables.size()));
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      data.inputs.row(static_cast<Eigen::Index>(k)) = Eigen::Map<Eigen::RowVectorXd>(
          inputs[k].data(), static_cast<Eigen::Index>(inputs[k].size()));
    }
    surrogate::FitOptions options;
    options.starts = 6;
    processes_.emplace(metric, surrogate::GaussianProcess::fit(layout, data, options));
  }
}

std::vector<double> Emulator::unit(const Design& x) const {
  std::vector<double> u(x.size());
  for (std::size_t j = 0; j < x.size(); ++j) u[j] = (x[j] - lower_[j]) / (upper_[j] - lower_[j]);
  return u;
}

std::optional<double> Emulator::value(const std::string& metric, const Design& x, std::size_t level,
                                      bool scatter) const {
  const std::vector<double> u = unit(x);
  const auto at_level = static_cast<int>(level_of_file_[level]);
  const surrogate::GaussianProcess& process = processes_.at(metric);
  const Eigen::MatrixXd input =
      Eigen::Map<const Eigen::RowVectorXd>(u.data(), static_cast<Eigen::Index>(u.size()));
  double z = process.predict(input, at_level).mean[0];
  if (scatter)
    z += process.noise(at_level) * hash_normal(u, fmt::format("{}-{}", metric, at_level));
  const double result = std::max(0.0, process.from_model(z));
  if (metric.starts_with("retention")) return std::min(1.0, result);
  if (*value(overflow_metric_, x, level, scatter) > all_retained) return std::nullopt;
  return result;
}

std::optional<double> Emulator::smooth(const std::string& metric, const Design& x,
                                       std::size_t level) const {
  return value(metric, x, level, false);
}

std::optional<double> Emulator::noisy(const std::string& metric, const Design& x,
                                      std::size_t level) const {
  return value(metric, x, level, true);
}

std::string Emulator::summary() const {
  std::string text;
  for (std::size_t k = 0; k < runs_.size(); ++k) {
    text += fmt::format("{}{} runs of {:g} mm", k == 0 ? "" : ", ", runs_[k],
                        1000.0 * file_spacings_[k]);
  }
  for (const auto& [metric, process] : processes_) {
    text += fmt::format("; {}: leave-one-out Q2 {:.3f}", metric, process.leave_one_out().q_squared);
  }
  return text;
}

}  // namespace parapet::bench::search
