/// Metrics that are formulas of modelled ones: what the surrogates of their inputs say of them.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "models.hpp"
#include "parapet/bayesian/problem.hpp"

namespace parapet::bayesian {

/// A composed metric at one design as a function of its inputs z [n_inputs] in model units; not
/// finite where it has no value.
using OfInputs = std::function<double(const Eigen::VectorXd& z)>;

/// The metrics with surrogates that a metric hangs on: itself, the inputs of its composition, or
/// none where it is exact.
std::vector<std::size_t> modelled_inputs(const Problem& problem, std::size_t metric);

/// Whether the surrogates can say something about a metric.
bool can_predict(const Problem& problem, const Models& models, std::size_t metric);

/// The composed metric at a design. Inputs beyond what is possible count as the nearest that is.
/// All must outlive it. Precondition: can_predict.
OfInputs of_inputs(const Problem& problem, const Models& models, std::size_t metric,
                   const Point& x);

/// How a function of independent normal inputs N(mean, sd^2) is split into a part that is sampled
/// and a normal remainder. A linear function is normal, and nothing is sampled; the more it bends
/// within one standard deviation, the larger is the share of the inputs' variance that is sampled
/// (after Astudillo and Frazier, Bayesian optimization of composite functions, ICML 2019, who
/// sample all of it), up to three quarters: what remains keeps the log of a gain finite.
struct NormalSplit {
  double sampled = 0.0;    ///< factor of the inputs' deviations in the sampled part, 0 .. 1
  double deviation = 0.0;  ///< of the remainder: standard deviation of the function
};
NormalSplit split(const OfInputs& f, const Eigen::VectorXd& mean, const Eigen::VectorXd& sd);

/// Median and 95 % interval of the function of such inputs, and the share of it within limits.
struct ComposedEstimate {
  double median = 0.0, lower = 0.0, upper = 0.0;  ///< NaN where it has no value
  double share_within = 1.0;
};
ComposedEstimate estimate_composed(const OfInputs& f, const Eigen::VectorXd& mean,
                                   const Eigen::VectorXd& sd, double lower_limit,
                                   double upper_limit);

/// Standard normal numbers [n], the same for the same seed and stream.
Eigen::VectorXd standard_normals(int n, std::uint64_t seed, std::uint64_t stream);

}  // namespace parapet::bayesian
