#include "flow_tools.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "balance.hpp"

namespace parapet::validation {

using solver::Flow;

void advance(Flow& flow, double time, const CaseRun& run, Balance* balance) {
  constexpr double close = 1e-12;  // [s]
  while (time - flow.time() > close) {
    run.check_cancelled();
    if (const auto failure = flow.step(time - flow.time())) {
      throw std::runtime_error(failure->reason + " at t = " + std::to_string(flow.time()) + " s");
    }
    if (balance) balance->add_step(flow);
  }
  run.watch_masses(flow);
}

void advance_sampled(Flow& flow, double end, double interval, const CaseRun& run,
                     const std::function<void(Flow&)>& sample, Balance* balance) {
  flow.refresh();
  sample(flow);
  const auto count = static_cast<long>(std::ceil(end / interval - 1e-9));
  for (long k = 1; k <= count; ++k) {
    advance(flow, std::min(end, static_cast<double>(k) * interval), run, balance);
    flow.refresh();
    sample(flow);
  }
}

double fitted_order(std::span<const double> spacings, std::span<const double> errors) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  const auto n = static_cast<double>(spacings.size());
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    const double x = std::log(spacings[k]), y = std::log(errors[k]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double rms_difference(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace parapet::validation
