#include "parapet/reports/run_summary.hpp"

#include <fmt/format.h>

#include <cmath>

#include "key_text.hpp"
#include "parapet/designs/text.hpp"
#include "parapet/math/units.hpp"

namespace parapet::reports {
namespace {

using solver::Metric;
using solver::Result;

/// The metric of that key; null where the run does not have a value for it.
const Metric* with_value(const Result& result, const std::string& key) {
  const Metric* metric = result.find_metric(key);
  return metric != nullptr && metric->value ? metric : nullptr;
}

/// "0.312 m", "0.312 ± 0.02 m", "61.3 %" (of a share, scaled by 100).
std::string quantity(const Metric& metric, double scale, std::string_view unit) {
  const double value = scale * *metric.value;
  std::string text = fmt::format("{:.3g}", value);
  if (std::abs(value) >= 1000.0) text = fmt::format("{:.0f}", value);
  if (metric.uncertainty && std::isfinite(metric.uncertainty->expanded)) {
    text += fmt::format(" ± {:.2g}", scale * metric.uncertainty->expanded);
  }
  return unit.empty() ? text : fmt::format("{}{}{}", text, unit == "°" ? "" : " ", unit);
}

std::string quantity(const Metric& metric) {
  return quantity(metric, 1.0, math::unit_of(metric.key).typographic);
}

std::string line(std::string_view label, const std::string& words) {
  return fmt::format("  {:<18}{}\n", label, designs::visible_text(words));
}

std::string_view why(solver::StopReason reason) {
  using enum solver::StopReason;
  switch (reason) {
    case end_time:
      return "the stop time was reached";
    case metrics_final:
      return "nothing that is measured can change any more";
    case settled:
      return "all debris is at rest";
    case drained:
      return "no debris is left in the channel";
    default:
      return solver::to_string(reason);
  }
}

std::string held_back(const Result& result) {
  const Metric* first = result.find_metric("retention_efficiency");
  if (first == nullptr) return {};
  if (!first->value) return line("held back", "not known: " + first->absent_reason);
  std::string words = quantity(*first, 100.0, "%") + " of the debris";
  // Several barriers: what the last one holds as well.
  const Metric* all = with_value(result, "retention_efficiency_total");
  if (all != nullptr && result.find_metric("barrier_2_retention_efficiency") != nullptr) {
    words += " by the first barrier, " + quantity(*all, 100.0, "%") + " by all";
  }
  if (const Metric* over = with_value(result, "overflow_volume_m3_per_m");
      over != nullptr && *over->value > 0.0) {
    words += "; " + quantity(*over) + " went over the first";
  }
  return line("held back", words);
}

std::string flight(const Result& result) {
  const Metric* length = result.find_metric("launch_length_m");
  if (length == nullptr || result.find_metric("barrier_1_design_force_n_per_m") == nullptr)
    return {};
  if (!length->value) {
    const bool none = length->absence == solver::Absence::does_not_exist;
    return line("flight", (none ? "none: " : "not known: ") + length->absent_reason);
  }
  std::string words = "landed " + quantity(*length) + " beyond the first barrier";
  if (const Metric* time = with_value(result, "impact_time_s")) {
    words += " at " + quantity(*time);
  }
  if (const Metric* speed = with_value(result, "landing_speed_m_s")) {
    words += ", with " + quantity(*speed);
  }
  return line("flight", words);
}

std::string loads(const Result& result) {
  std::string text;
  for (int k = 1;; ++k) {
    const std::string barrier = fmt::format("barrier_{}_", k);
    const Metric* force = result.find_metric(barrier + "design_force_n_per_m");
    if (force == nullptr) return text;
    const std::string label = fmt::format("load on barrier {}", k);
    if (!force->value) {
      text += line(label, "not known: " + force->absent_reason);
      continue;
    }
    std::string words = quantity(*force);
    if (const Metric* moment = with_value(result, barrier + "design_moment_nm_per_m")) {
      words += ", moment about the foot " + quantity(*moment);
    }
    if (const Metric* height = with_value(result, barrier + "run_up_height_m")) {
      words += "; the debris rose to " + quantity(*height);
    }
    if (const Metric* alpha = with_value(result, barrier + "hydrodynamic_coefficient")) {
      words += fmt::format("; alpha of alpha rho v^2 h {:.3g}", *alpha->value);
    }
    if (const Metric* k_factor = with_value(result, barrier + "hydrostatic_coefficient")) {
      words += fmt::format("; k of k rho g h^2/2 {:.3g}", *k_factor->value);
    }
    text += line(label, words);
  }
}

std::string approach(const Result& result) {
  const Metric* speed = with_value(result, "front_velocity_m_s");
  const Metric* time = with_value(result, "arrival_time_s");
  const Metric* depth = with_value(result, "flow_depth_max_m");
  std::string words;
  if (speed != nullptr) words = "front of " + quantity(*speed);
  if (time != nullptr) words += (words.empty() ? "arrived at " : " at ") + quantity(*time);
  if (depth != nullptr) words += (words.empty() ? "" : ", ") + quantity(*depth) + " deep";
  return words.empty() ? std::string() : line("approach", words);
}

}  // namespace

std::string run_summary(const Result& result) {
  std::string text;
  if (result.status == solver::Status::ok) {
    text = line("ended", fmt::format("after {:.3g} s of flow: {}", result.stop_time,
                                     why(result.stop_reason)));
  } else {
    text = line("FAILED", fmt::format("at {:.3g} s of flow: {}", result.stop_time, result.reason));
  }
  text += approach(result) + held_back(result) + flight(result) + loads(result);
  for (const solver::Warning& warning : result.warnings) text += line("warning", warning.text);
  return text;
}

}  // namespace parapet::reports
