/// Expected hypervolume improvement in log space, with noise and constraints.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "parapet/acquisition/boxes.hpp"

namespace parapet::acquisition {

/// log of sigma h(x / sigma) with h(t) = phi(t) + t Phi(t): the log of E[max(0, x + sigma Z)].
/// Accurate where h underflows (t down to -1e150), after Ament et al. (Unexpected improvements to
/// expected improvement, NeurIPS 2023). sigma = 0 gives log(max(0, x)).
double log_expected_excess(double x, double sigma);

/// log(exp(a) - exp(b)) for a >= b; -infinity also where rounding turned their order.
double log_difference(double a, double b);

/// log(exp(a) + exp(b)).
double log_sum(double a, double b);

/// log of the mean of exp(v); -infinity for an empty v.
double log_mean(const Eigen::VectorXd& v);

/// log of the expected hypervolume improvement of y_j ~ N(mean_j, sd_j^2), independent, over the
/// boxes of undominated_boxes: a closed form,
///   EHVI = sum_boxes prod_j (E[(upper_j - y_j)+] - E[(lower_j - y_j)+])
/// (Yang et al., Swarm Evol. Comput. 44 (2019) 945-956). -infinity only without boxes or where sd
/// is 0. With one objective it is the log of the expected improvement.
/// @throws std::invalid_argument for vectors of different length.
double log_ehvi(const std::vector<Box>& boxes, const Objectives& mean, const Objectives& sd);

/// log of the probability that lower <= y <= upper for y ~ N(mean, sd^2); limits may be infinite.
double log_probability_within(double mean, double sd, double lower, double upper);

/// The front under each posterior draw of the designs evaluated or still being evaluated, so that
/// noise in what was measured and the outcomes of pending designs are averaged over (Daulton,
/// Balandat and Bakshy, Parallel Bayesian optimization of multiple noisy objectives, NeurIPS 2021).
class NoisyFront {
 public:
  /// objectives: n_samples matrices [n_designs, n_objectives], minimised; feasible: n_samples
  /// vectors [n_designs] (1 or 0): whether the draw meets the constraints. A design counts only in
  /// the draws where it does; in a draw without any the boxes are all of {ideal < y <= reference}.
  /// @throws std::invalid_argument for shapes that do not fit, or no draw at all.
  NoisyFront(const std::vector<Eigen::MatrixXd>& objectives,
             const std::vector<Eigen::VectorXi>& feasible, const Objectives& reference,
             const Objectives& ideal);

  /// log of the mean over draws of (expected hypervolume improvement times probability of meeting
  /// the constraints). means: [n_samples, n_objectives], sd: [n_objectives], log_feasible:
  /// [n_samples]. The posterior of the candidate given one draw of the others has the same sd for
  /// every draw. Safe to call from several threads.
  /// @throws std::invalid_argument for shapes that do not fit, values that are not numbers or a
  /// negative standard deviation.
  double log_improvement(const Eigen::MatrixXd& means, const Objectives& sd,
                         const Eigen::VectorXd& log_feasible) const;

  /// The same where the deviation differs from draw to draw, over the first draws alone if there
  /// are fewer rows: means and deviations [n <= n_samples, n_objectives], log_feasible [n].
  double log_improvement_by_draw(const Eigen::MatrixXd& means, const Eigen::MatrixXd& deviations,
                                 const Eigen::VectorXd& log_feasible) const;

  bool any_feasible() const { return any_feasible_; }  ///< in at least one draw
  /// Number of posterior draws.
  int n_samples() const { return static_cast<int>(fronts_.size()); }

 private:
  struct Side {  // positions among the limits
    int lower, upper;
  };
  struct Front {  // the undominated boxes of one draw
    Front(const std::vector<Box>& boxes, std::size_t n_objectives);
    std::vector<std::vector<double>> limits;  // [n_objectives], sorted: neighbours share them
    std::vector<Side> sides;                  // [n_boxes, n_objectives]
    std::size_t n_boxes;
  };
  struct Excess {  // of one limit
    double straight, tail;
  };

  double plain_improvement(const Front& front, const double* mean, const double* sd,
                           std::vector<Excess>& excess) const;
  double log_improvement_of(const Front& front, const double* mean, const double* sd,
                            std::vector<Excess>& excess) const;

  std::vector<Front> fronts_;  // [n_samples]
  std::size_t n_objectives_ = 0, most_limits_ = 0;
  bool any_feasible_ = false;
};

}  // namespace parapet::acquisition
