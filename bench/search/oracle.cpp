#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "hash_noise.hpp"
#include "median.hpp"

namespace parapet::bench::search {
namespace {

// Shares lie in 0..1, lengths, forces and volumes are not negative.
std::pair<double, double> physical_bounds(const std::string& metric) {
  const bool share = metric.find("efficiency") != std::string::npos;
  return {0.0, share ? 1.0 : std::numeric_limits<double>::infinity()};
}

// Weights of the fit of some rows, with zeros for the others.
Eigen::VectorXd spread(const Eigen::VectorXd& weights, const std::vector<Eigen::Index>& members,
                       Eigen::Index n) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(n);
  for (std::size_t k = 0; k < members.size(); ++k) {
    all[members[k]] = weights[static_cast<Eigen::Index>(k)];
  }
  return all;
}

MetricSurface fit_metric(const std::string& metric, const Eigen::MatrixXd& designs,
                         const std::vector<std::optional<double>>& values) {
  std::vector<Eigen::Index> members;
  Eigen::VectorXd present = Eigen::VectorXd::Constant(designs.rows(), -1.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    members.push_back(static_cast<Eigen::Index>(i));
    present[static_cast<Eigen::Index>(i)] = 1.0;
  }
  const auto n_members = static_cast<Eigen::Index>(members.size());
  Eigen::MatrixXd where(n_members, designs.cols());
  Eigen::VectorXd what(n_members);
  for (Eigen::Index k = 0; k < n_members; ++k) {
    const auto row = members[static_cast<std::size_t>(k)];
    where.row(k) = designs.row(row);
    what[k] = *values[static_cast<std::size_t>(row)];
  }
  const auto [least, greatest] = physical_bounds(metric);
  MetricSurface surface{fit_radial(where, what), least, greatest, {}, 0.0};
  RadialSurface& s = surface.fit.surface;
  s.weights = spread(s.weights, members, designs.rows());
  if (n_members < designs.rows()) {
    const RadialFit presence = fit_radial(designs, present);
    surface.presence = presence.surface;
    for (Eigen::Index i = 0; i < designs.rows(); ++i) {
      const double predicted = present[i] - presence.leave_one_out[i];
      if (predicted * present[i] <= 0.0) surface.presence_errors += 1.0;
    }
    surface.presence_errors /= static_cast<double>(designs.rows());
  }
  return surface;
}

Eigen::VectorXd as_vector(const std::vector<double>& u) {
  return Eigen::Map<const Eigen::VectorXd>(u.data(), static_cast<Eigen::Index>(u.size()));
}

}  // namespace

std::vector<double> Oracle::to_unit(const std::vector<double>& x) const {
  std::vector<double> u(x.size());
  for (std::size_t j = 0; j < x.size(); ++j) u[j] = (x[j] - lower[j]) / (upper[j] - lower[j]);
  return u;
}

bool Oracle::succeeds(const std::vector<double>& x) const {
  if (failed.empty()) return true;
  const Eigen::VectorXd u = as_vector(to_unit(x));
  double bad = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& f : failed) bad = std::min(bad, (as_vector(f) - u).squaredNorm());
  const double good = (designs.rowwise() - u.transpose()).rowwise().squaredNorm().minCoeff();
  return good <= bad;
}

std::optional<double> Oracle::smooth(const std::string& metric,
                                     const std::vector<double>& x) const {
  const MetricSurface& m = metrics.at(metric);
  const Eigen::VectorXd u = as_vector(to_unit(x));
  if (m.presence && m.presence->at(designs, u) <= 0.0) return std::nullopt;
  return std::clamp(m.fit.surface.at(designs, u), m.least, m.greatest);
}

std::optional<double> Oracle::noisy(const std::string& metric, const std::vector<double>& x) const {
  const MetricSurface& m = metrics.at(metric);
  const std::vector<double> u = to_unit(x);
  const Eigen::VectorXd at = as_vector(u);
  if (m.presence && m.presence->at(designs, at) <= 0.0) return std::nullopt;
  const double noise = m.fit.noise * hash_normal(u, name + "/" + metric);
  return std::clamp(m.fit.surface.at(designs, at) + noise, m.least, m.greatest);
}

Oracle fit_oracle(const std::string& name, const std::vector<std::string>& variables,
                  const std::vector<double>& lower, const std::vector<double>& upper,
                  const std::vector<TableRow>& rows, const std::vector<std::string>& metrics) {
  Oracle oracle;
  oracle.name = name;
  oracle.variables = variables;
  oracle.lower = lower;
  oracle.upper = upper;
  std::vector<double> cpu_times;
  std::vector<const TableRow*> good;
  for (const TableRow& row : rows) {
    if (row.ok) {
      good.push_back(&row);
      cpu_times.push_back(row.cpu_time);
    } else {
      oracle.failed.push_back(row.u);
    }
  }
  if (good.empty()) throw std::invalid_argument("no simulation of the table came to an end");
  oracle.median_cpu_time = median(cpu_times);
  const auto n = static_cast<Eigen::Index>(good.size());
  oracle.designs.resize(n, static_cast<Eigen::Index>(variables.size()));
  for (Eigen::Index i = 0; i < n; ++i) {
    oracle.designs.row(i) = as_vector(good[static_cast<std::size_t>(i)]->u).transpose();
    for (double& u : oracle.designs.row(i)) u = rounded(u, design_digits);
  }
  for (const std::string& metric : metrics) {
    std::vector<std::optional<double>> values;
    for (const TableRow* row : good) {
      const auto found = row->metrics.find(metric);
      values.push_back(found == row->metrics.end() ? std::nullopt : found->second);
    }
    oracle.metrics.emplace(metric, fit_metric(metric, oracle.designs, values));
  }
  return oracle;
}

}  // namespace parapet::bench::search
