#include "quality.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "parapet/flow/index.hpp"
#include "parapet/flow/shifting.hpp"

namespace parapet::solver {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace

double spray_share(const Fluid& f) {
  double spray = 0.0, all = 0.0;
  for (std::size_t i = 0; i < at(f.n); ++i) {
    all += f.mass[i];
    if (is_spray(f.lambda[i])) spray += f.mass[i];
  }
  return all > 0.0 ? spray / all : 0.0;
}

double density_error(const Fluid& f, double reference_density, double mass_share) {
  struct Parcel {
    double error, mass;
  };
  std::vector<Parcel> parcels;
  double beyond = 0.0;
  for (std::size_t i = 0; i < at(f.n); ++i) {
    parcels.push_back({std::abs(f.density[i] / reference_density - 1.0), f.mass[i]});
    beyond += mass_share * f.mass[i];
  }
  const auto worse = [](const Parcel& a, const Parcel& b) {
    return a.error > b.error || (a.error == b.error && a.mass > b.mass);
  };
  // as many of the worst at a time as would do if all had the same mass, and a few more
  const auto some = static_cast<std::ptrdiff_t>(2.0 * mass_share * f.n) + 8;
  for (auto from = parcels.begin(); from != parcels.end();) {
    const auto to = from + std::min(some, parcels.end() - from);
    std::nth_element(from, to - 1, parcels.end(), worse);
    std::sort(from, to, worse);
    for (; from != to; ++from) {
      beyond -= from->mass;
      if (beyond < 0.0) return from->error;
    }
  }
  return 0.0;
}

double mass_spread(const Fluid& f) {
  if (f.n == 0) return 0.0;
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < at(f.n); ++i) sum += f.mass[i];
  const double mean = sum / f.n;
  for (std::size_t i = 0; i < at(f.n); ++i) {
    squares += (f.mass[i] - mean) * (f.mass[i] - mean);
  }
  return std::sqrt(squares / f.n) / mean;
}

void EnergyGain::observe(double energy) {
  if (!begun_) lowest_ = energy;
  begun_ = true;
  lowest_ = std::min(lowest_, energy);
  largest_ = std::max(largest_, energy - lowest_);
}

std::vector<Warning> warnings_of(const Quality& q, bool unfinished, double stop_time) {
  std::vector<Warning> warnings;
  const auto most = [&](const char* key, double value, double limit, const std::string& text) {
    if (value > limit) warnings.push_back({key, value, limit, text});
  };
  using L = QualityLimits;
  most("energy_gain_ratio", q.energy_gain_ratio, L::energy_gain_ratio,
       "the scheme created " + number(100.0 * q.energy_gain_ratio) +
           " % of the released block's energy: a flow with too little friction for its particles");
  most("density_error_bulk", q.density_error_bulk, L::density_error_bulk,
       "densities were off by " + number(100.0 * q.density_error_bulk) + " % and more in " +
           number(100.0 * density_mass_share) +
           " % of the mass: loads and run-up at that moment are not trustworthy");
  most("mass_spread", q.mass_spread, L::mass_spread,
       "the particles' masses have come to vary by " + number(100.0 * q.mass_spread) + " %");
  most("spray_share_max", q.spray_share_max, L::spray_share_max,
       number(100.0 * q.spray_share_max) +
           " % of the mass was spray at once: single particles, not a flow");
  most("wall_contacts_per_particle", q.wall_contacts_per_particle, L::wall_contacts_per_particle,
       "particles were stopped at walls " + number(q.wall_contacts_per_particle) +
           " times each: plates too thin or too coarsely resolved");
  if (q.particles_across_approach && *q.particles_across_approach < L::particles_across_approach) {
    warnings.push_back(
        {"particles_across_approach", *q.particles_across_approach, L::particles_across_approach,
         "the flow that meets the first barrier is only " + number(*q.particles_across_approach) +
             " particles deep: its metrics are not resolved"});
  }
  if (unfinished) {
    warnings.push_back({"stop_time", stop_time, stop_time,
                        "the run ended at its stop time, " + number(stop_time) +
                            " s, while metrics could still change: give it longer"});
  }
  return warnings;
}

}  // namespace parapet::solver
