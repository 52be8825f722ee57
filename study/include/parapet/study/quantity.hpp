/// One number of a design: a statistic of a metric, or of an expression, over the events that the
/// design is judged under.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::study {

/// What one event's simulation gave. All weights together are 1.
struct Event {
  std::string name;  ///< of the scenario; empty for the base event
  double weight = 1.0;
  std::vector<solver::Metric> metrics;
};

/// A statistic of a metric, or of an expression that is evaluated in each event. Equal members mean
/// the same number for every design.
///
/// An event in which the metric does not exist counts with `value_when_absent` where that is given.
/// Otherwise it stands at the good end of all values or at the bad one (`absent_is_good`); one in
/// which it is unknown, because the run was too short or too coarse to tell, always at the bad one:
///   mean: it is left out, the other weights are rescaled; at the bad end there is no mean
///   worst: it is passed over; at the bad end there is no worst value
///   quantile: it takes its place in the order; the quantile has no value where it falls on it
///   probability: it counts as within the limits, or as outside
/// An expression exists in an event where its metrics do, or have a value of values_when_absent,
/// and where it is finite; it is unknown where one of its metrics is.
struct Quantity {
  std::string metric;  ///< of an expression: its name
  designs::Statistic statistic = designs::Statistic::mean;
  double quantile = 1.0;        ///< of the statistic quantile, else 1
  bool high_is_good = false;    ///< which end is good: for worst and quantile, else false
  std::optional<double> lower;  ///< of the statistic probability
  std::optional<double> upper;
  std::optional<double> value_when_absent;
  bool absent_is_good = false;
  std::string expression = {};                            ///< written out; empty for a metric
  std::vector<std::string> metrics = {};                  ///< that the expression uses
  std::map<std::string, double> values_when_absent = {};  ///< of these metrics
  std::string event = {};  ///< the value in this event alone; empty: over all

  /// Equal in every member.
  bool operator==(const Quantity&) const = default;
};

/// Its value for one design.
struct QuantityValue {
  std::optional<double> value;  ///< empty: see Quantity::absent_is_good for what that means
  bool absent = false;          ///< the metric has no value in at least one event
  bool unknown = false;         ///< there is no value because a run was too short or too coarse
  std::string reason;           ///< why, of the first such event
};

/// The value of a quantity on a metric over the events of a design.
QuantityValue quantity_value(const Quantity& quantity, const std::vector<Event>& events);

/// The same of any quantity.
QuantityValue quantity_value(const designs::StudySpec& study, const Quantity& quantity,
                             const designs::Design& design, const std::vector<Event>& events);

/// The quantity's statistic of values that are all there; weights of sum 1.
double statistic_of(const Quantity& quantity, const std::vector<double>& values,
                    const std::vector<double>& weights);

/// What an expression is in one event, as a metric called `key`.
solver::Metric expression_metric(const designs::StudySpec& study, const Quantity& quantity,
                                 const designs::Design& design,
                                 const std::vector<solver::Metric>& metrics);

/// "launch_length_m", "launch_length_m (highest value)",
/// "P(0.95 <= retention_efficiency)" and so on.
std::string quantity_name(const Quantity& quantity);

/// The events of a logged design: its scenarios, or the base event alone.
std::vector<Event> events_of(const records::EvaluationRecord& record);

/// Weighted means over the events that have a value; a metric without any keeps its reason. The
/// metrics of a single event are returned as they are.
std::vector<solver::Metric> mean_metrics(const std::vector<Event>& events);

}  // namespace parapet::study
