#include "balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace parapet::validation {

using solver::Flow;

Balance::Balance(const Flow& flow) : start_(totals(flow)), scale_(norm(start_.momentum)) {}

void Balance::add_step(Flow& flow) {
  const double dt = flow.last_time_step();
  const Totals now = totals(flow);
  dissipated_ += dt * now.dissipation;
  impulse_ = impulse_ + (dt * now.mass) * flow.setup().gravity;
  scale_ =
      std::max({scale_, norm(now.momentum), now.mass * norm(flow.setup().gravity) * flow.time()});
  last_ = flow.take_impulses();
  impulses_.resize(last_.size());
  for (std::size_t k = 0; k < last_.size(); ++k) {
    impulse_ = impulse_ - last_[k].force;
    impulses_[k].force = impulses_[k].force + last_[k].force;
    impulses_[k].moment += last_[k].moment;
  }
}

double Balance::mass_change(const Flow& flow) const {
  return (totals(flow).mass + flow.left_mass()) / start_.mass - 1.0;
}

double Balance::momentum_error(const Flow& flow) const {
  return norm(totals(flow).momentum - start_.momentum - impulse_) / scale_;
}

double Balance::energy_loss(const Flow& flow) const {
  const Totals now = totals(flow);
  return (start_.kinetic + start_.potential + start_.elastic) -
         (now.kinetic + now.potential + now.elastic);
}

double Balance::numerical_share(const Flow& flow, double scale) const {
  const double lost = energy_loss(flow);
  return (lost - dissipated_) / (scale > 0.0 ? scale : lost);
}

void add_balance(CaseRun& run, const std::string& key, const std::string& of,
                 const Balance& balance, const Flow& flow) {
  run.add({.key = key + "_mass",
           .what = of + ": change of the mass",
           .value = balance.mass_change(flow),
           .lower = -1e-12,
           .upper = 1e-12,
           .reason = "particles exchange equal and opposite masses; rounding of the sum"});
  run.add({.key = key + "_momentum",
           .what = of + ": momentum not explained by gravity and wall forces",
           .value = 100.0 * balance.momentum_error(flow),
           .unit = "%",
           .upper = 1.0,
           .reason = "pair forces (but for the tensile-instability control's) and what shifting "
                     "exchanges are opposite and equal; the wall's "
                     "velocity lags by a step; share of the impulse of gravity"});
}

}  // namespace parapet::validation
