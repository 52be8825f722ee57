#include "parapet/solver/result.hpp"

namespace parapet::solver {

std::string_view to_string(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::failed:
      return "failed";
    case Status::cancelled:
      return "cancelled";
  }
  return "unknown";
}

std::string_view to_string(StopReason reason) {
  switch (reason) {
    case StopReason::end_time:
      return "end_time";
    case StopReason::metrics_final:
      return "metrics_final";
    case StopReason::settled:
      return "settled";
    case StopReason::drained:
      return "drained";
    case StopReason::not_a_number:
      return "not_a_number";
    case StopReason::runaway_speed:
      return "runaway_speed";
    case StopReason::density_range:
      return "density_range";
    case StopReason::time_step_collapse:
      return "time_step_collapse";
    case StopReason::viscous_solver:
      return "viscous_solver";
    case StopReason::cancelled:
      return "cancelled";
  }
  return "unknown";
}

std::string_view to_string(Absence absence) {
  switch (absence) {
    case Absence::none:
      return "";
    case Absence::does_not_exist:
      return "does_not_exist";
    case Absence::run_too_short:
      return "run_too_short";
    case Absence::too_coarse:
      break;
  }
  return "too_coarse";
}

Absence absence_of(std::string_view word) {
  for (const Absence absence : {Absence::run_too_short, Absence::too_coarse}) {
    if (word == to_string(absence)) return absence;
  }
  return Absence::does_not_exist;
}

const Metric* Result::find_metric(std::string_view key) const {
  for (const Metric& metric : metrics) {
    if (metric.key == key) return &metric;
  }
  return nullptr;
}

}  // namespace parapet::solver
