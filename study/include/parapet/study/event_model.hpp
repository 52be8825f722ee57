/// Statistics over a distribution of events, from the few events that were simulated.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parapet/bayesian/space.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/quantity.hpp"
#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::study {

/// How well a surrogate of design and event predicts an event that it has not seen: all simulations
/// of one event are left out, predicted from those of the others, and so for each event.
struct LeaveOneEventOut {
  double rmse = 0.0;         ///< root mean square error, in the metric's unit
  double q_squared = 0.0;    ///< 1 - its square over the variance of the values
  double coverage_95 = 0.0;  ///< share of simulations within their 95 % intervals
};

/// A statistic over the distribution, for one design.
struct DistributionStatistic {
  double value = 0.0;  ///< median: of n_event_draws events on the means, and what draws add
  double lower_95 = 0.0, upper_95 = 0.0;  ///< what the surrogates leave open of it
};

/// One surrogate for each metric that a statistic hangs on, over design and event together: the
/// event variables are inputs beside the design's. Of a study whose scenarios are drawn from
/// distributions; records at the finest spacing that ended well count.
class EventModel {
 public:
  /// What is modelled: a metric with the value that stands for it where it does not exist.
  using Key = std::pair<std::string, std::optional<double>>;

  /// `study` must outlive it.
  /// @param starts of each surrogate's fit
  EventModel(const designs::StudySpec& study, const std::vector<records::EvaluationRecord>& records,
             int starts = 4);

  /// Whether there is anything to model: event variables, and enough simulations of each metric.
  bool empty() const { return processes_.empty(); }

  /// Number of designs that it learnt from.
  std::size_t n_designs() const { return n_designs_; }

  /// The metrics with surrogates, in order.
  const std::map<Key, surrogate::GaussianProcess>& processes() const { return processes_; }

  /// The value alone, over the first so many of the drawn events.
  std::optional<double> value(const Quantity& quantity, const designs::Design& design,
                              std::size_t n_events = designs::n_event_draws) const;

  /// Empty where a metric that the quantity hangs on has no surrogate.
  std::optional<DistributionStatistic> statistic(const Quantity& quantity,
                                                 const designs::Design& design) const;

  LeaveOneEventOut leave_one_event_out(const Key& key) const;  ///< of one metric

 private:
  struct Row {
    std::size_t event;
    Eigen::RowVectorXd input;
    double value;
  };

  void collect(const std::vector<records::EvaluationRecord>& records);
  void fit(int starts);
  Eigen::MatrixXd inputs(const designs::Design& design, std::size_t n_events) const;
  std::optional<double> of_events(const Quantity& quantity, const designs::Design& design,
                                  const std::vector<Eigen::VectorXd>& values) const;

  const designs::StudySpec& study_;
  bayesian::Space space_;
  surrogate::Layout layout_;
  Eigen::MatrixXd events_;  // [n_events, n_event_variables], scaled
  Eigen::MatrixXd draws_;   // [n_event_draws, n_event_variables], scaled
  std::map<Key, std::vector<Row>> rows_;
  std::map<Key, surrogate::GaussianProcess> processes_;
  std::size_t n_designs_ = 0;
};

/// Fewest designs from which statistics over the distribution are estimated.
constexpr std::size_t fewest_event_designs = 4;

/// Tells a search of a study with a distribution what the surrogates of design and event say, after
/// all that was told, of the statistics of each design at the finest spacing: in the place of those
/// over the simulated events. Does nothing while there are fewer than fewest_event_designs.
/// @param told what the search was told, in order
void revise_statistics(const designs::StudySpec& study, const SearchProblem& problem,
                       const std::vector<records::EvaluationRecord>& told,
                       bayesian::Search& search);

/// The quantities of a study that are statistics over events, of objectives first.
std::vector<Quantity> event_quantities(const designs::StudySpec& study);

/// Whether a study's statistics are over a distribution.
bool has_distribution(const designs::StudySpec& study);

}  // namespace parapet::study
