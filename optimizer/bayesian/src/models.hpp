/// The surrogates of a search: one process per metric, and one for success.
#pragma once

#include <optional>
#include <vector>

#include "parapet/surrogate/gaussian_process.hpp"
#include "parapet/surrogate/success_model.hpp"
#include "told.hpp"

namespace parapet::bayesian {

class Models {
 public:
  Models(const Problem& problem, std::uint64_t seed);

  /// Brings the surrogates up to date with what was told. Parameters are fitted anew while there
  /// are few data, and later each time the data have grown by a twentieth (many: a tenth); in
  /// between the processes are conditioned on the new data with the parameters that they have.
  /// `revised`: values of what was told before are others now.
  void update(const std::vector<Told>& told, bool revised = false);

  /// Null for an exact or composed metric and for one without data.
  const surrogate::GaussianProcess* process(std::size_t metric) const {
    return processes_[metric] ? &*processes_[metric] : nullptr;
  }
  const surrogate::SuccessModel* success() const { return success_ ? &*success_ : nullptr; }

  /// log of the probability that an evaluation of these inputs [m, n_features] succeeds.
  Eigen::VectorXd log_success(const Eigen::MatrixXd& inputs) const;

 private:
  bool due(std::size_t n_data, std::size_t& fitted_at) const;
  void update_process(std::size_t metric, const std::vector<Told>& told, bool revised);
  void update_success(const std::vector<Told>& told);

  const Problem& problem_;
  std::uint64_t seed_;
  surrogate::Layout layout_;
  std::vector<std::optional<surrogate::GaussianProcess>> processes_;  // [n_metrics]
  std::vector<std::size_t> fitted_at_;                                // [n_metrics] data then
  std::vector<int> fits_;                                             // [n_metrics] so far
  std::optional<surrogate::SuccessModel> success_;
  std::size_t success_fitted_at_ = 0;
};

}  // namespace parapet::bayesian
