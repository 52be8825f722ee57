/// The surrogates of a study's quantities, as surrogates.json holds them, ready to be asked.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "parapet/bayesian/space.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/repeat.hpp"
#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::study {

/// Which quantity of a study: the objective of that number, or the limit of that number (limits of
/// constraints on metrics, in the order of constraint_quantities over the spec's constraints).
struct GoalPlace {
  /// What the number counts.
  enum class Kind { objective, limit };
  Kind kind = Kind::objective;
  std::size_t number = 0;
};

/// Runs of a study that have a quantity, and the values that it can have at all.
struct RunSamples {
  std::vector<const designs::Design*> designs = {};  ///< [n_runs]
  std::vector<double> spacings = {};                 ///< [n_runs] particle spacing [m]
  std::vector<double> values = {};                   ///< [n_runs]
  double least = 0.0, greatest = 0.0;
};

/// Surrogates of the objectives and limits on metrics. Threads may share it.
class StudySurrogates {
 public:
  /// Empty where the file is missing, not whole, of another study or not to be understood: what it
  /// tells is a help and not needed.
  ///
  /// The search models the metrics of an expression, not its value. Here the value has a process of
  /// its own, fitted to what it was in the runs, so that its scatter is that of the expression. Nor
  /// does the search of a study over a distribution model what runs say of the simulated events,
  /// and a repeat would: there, every quantity has a process of its own.
  /// @param spec_hash that the file must state
  /// @param runs of the study
  static std::shared_ptr<const StudySurrogates> read(
      const designs::StudySpec& study, const std::filesystem::path& file,
      const std::string& spec_hash, const std::vector<records::EvaluationRecord>& runs);

  /// From the content of surrogates.json. Empty likewise.
  static std::shared_ptr<const StudySurrogates> of(
      const designs::StudySpec& study, const designs::Json& surrogates,
      const std::vector<records::EvaluationRecord>& runs);

  /// What the surrogate of a goal says of each design at a particle spacing [m], [n_designs]; empty
  /// where there is none (a formula, too few designs) or the spacing is none of the study's.
  ///
  /// A fit to few runs may take their scatter for the shape of the response and stop at a noise of
  /// nearly nothing. So the process is fitted again with a noise of 5, 10, 20 and 40 % of the
  /// spread of the values, and all fits are averaged by their likelihoods, unless the study knows
  /// the noise or there are more than 150 runs.
  ///
  /// Deviation and noise are larger than the process states where designs left out of it lie
  /// farther off than it says: by the root mean square of the standardised leave-one-out residuals
  /// at that spacing, if above 1. The noise has a quarter as many degrees of freedom as there are
  /// runs at that spacing, at least 2.
  std::vector<SurrogateBelief> beliefs(const GoalPlace& goal,
                                       const std::vector<const designs::Design*>& designs,
                                       double spacing) const;

  /// The same of a quantity that the study's search did not model, by a process fitted to these
  /// runs with the same space; empty where fewer than five have the quantity.
  std::optional<SurrogateBelief> fitted_belief(const RunSamples& samples,
                                               const designs::Design& design, double spacing) const;

  /// Joint draws of the noise-free values [n_draws, n_designs], in the goal's unit, within its
  /// possible values; no columns where there is no surrogate. The same seed gives the same draws.
  Eigen::MatrixXd draws(const GoalPlace& goal, const std::vector<const designs::Design*>& designs,
                        double spacing, int count, std::uint64_t seed) const;

 private:
  struct Fit {
    surrogate::GaussianProcess process;
    double weight = 1.0;                 // of all fits 1
    std::vector<double> inflation = {};  // [n_levels]
  };
  /// Made when they are first asked for: reading a folder must not cost fits.
  struct Fits {
    std::once_flag made;
    std::optional<surrogate::GaussianProcess> stored;
    std::optional<surrogate::Data> data;  // in its place: to be fitted
    surrogate::Layout layout;             // of the data
    bool noise_known = false;
    std::vector<Fit> fits = {};  // at least one once made
  };
  struct Model {
    std::shared_ptr<Fits> lazy;
    double least = 0.0, greatest = 0.0;
    std::vector<double> noise_freedom = {};  // [n_levels]
  };
  static const std::vector<Fit>& fits_of(const Model& model);
  static std::vector<Fit> make_fits(surrogate::GaussianProcess process, bool noise_known);

  StudySurrogates(bayesian::Space space, std::vector<designs::Variable> variables)
      : space_(std::move(space)), variables_(std::move(variables)) {}
  static std::vector<double> noise_freedom_of(const surrogate::Data& data, std::size_t levels);
  // Empty where fewer than five runs have the quantity.
  std::optional<Model> model_of(const RunSamples& samples) const;
  const Model* find(const GoalPlace& goal) const;
  std::vector<SurrogateBelief> beliefs_of(const Model& model,
                                          const std::vector<const designs::Design*>& designs,
                                          int level) const;
  std::optional<int> level(double spacing) const;
  Eigen::MatrixXd features(const std::vector<const designs::Design*>& designs) const;

  bayesian::Space space_;
  std::vector<designs::Variable> variables_;
  std::vector<double> spacings_;              // [n_levels], finest first
  std::vector<std::optional<Model>> models_;  // [n_metrics]
  std::vector<std::size_t> objectives_;       // [n_objectives] place in models_
  std::vector<std::size_t> limits_;           // [n_limits] likewise
};

}  // namespace parapet::study
