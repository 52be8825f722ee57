// Copies of one event at any size: lengths times s, times and speeds times the root of s. With a
// flow index of 1 and s a power of 4 every step is the same but for the exponents of its numbers,
// so that every metric, measured in units of the event, must be equal to the last bits.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "parapet/designs/case_spec.hpp"
#include "parapet/math/units.hpp"

namespace parapet::designs {
namespace {

/// A released block of 0.3 x 0.2 m times `size`, all other lengths default but for the spacing.
Json event(double size, bool open_channel) {
  Json json = Json::parse(R"({
    "format": "parapet-case/1", "name": "copy",
    "material": {"density_kg_m3": 1024, "flow_index": 1},
    "run": {}, "gauges": {}
  })");
  const double longer = std::sqrt(size);
  json["reservoir"] = {{"length_m", 0.3 * size}, {"height_m", 0.2 * size}};
  json["material"]["yield_stress_pa"] = 90.0 * size;
  json["material"]["consistency_pa_sn"] = 1.5 * size * longer;
  json["material"]["cutoff_shear_rate_per_s"] = 0.1 / longer;
  json["numerics"] = {{"spacing_m", 0.01 * size}};
  // windows that 10 mm resolve
  json["gauges"] = {{"arrival_window_ratio", 0.25},
                    {"dead_zone_window_ratio", 0.25},
                    {"run_up_mass_share", 0.005}};
  json["gauges"]["ramp_column_ratio"] = 0.5;
  if (!open_channel) json["run"]["reading_time_s"] = 1.05 * longer;
  if (!open_channel) {
    json["approach"] = {{{"front_velocity_m_s", 1.7 * longer}, {"flow_depth_max_m", 0.05 * size}}};
  }
  if (!open_channel) json["barriers"] = Json::parse(R"([{"deflector": {"angle_deg": 45}}])");
  return json;
}

solver::Result run(const Json& json) {
  const CaseSpec spec = parse_case(json, "copy");
  return solver::simulate(spec.scene, spec.numerics, spec.run);
}

/// What a metric in this unit is multiplied by in a copy with lengths times `size`.
double factor(std::string_view unit, double size) {
  const double longer = std::sqrt(size);
  if (unit.empty() || unit == "deg") return 1.0;
  if (unit == "m") return size;
  if (unit == "s" || unit == "m/s") return longer;
  if (unit == "m3/m" || unit == "m2") return size * size;
  if (unit == "m2/s") return size * longer;
  if (unit == "N/m") return size * size;
  if (unit == "J/m" || unit == "N m/m") return size * size * size;
  if (unit == "N s/m") return size * size * longer;
  ADD_FAILURE() << "a metric in " << unit;
  return 0.0;
}

class Scaling : public testing::TestWithParam<bool> {};

TEST_P(Scaling, EveryMetricOfACopyIsThatOfTheOriginalInUnitsOfTheEvent) {
  const bool open_channel = GetParam();
  const solver::Result one = run(event(1.0, open_channel));
  ASSERT_EQ(one.status, solver::Status::ok) << one.reason;
  ASSERT_EQ(one.stop_reason, solver::StopReason::metrics_final);
  int values = 0;
  for (const solver::Metric& metric : one.metrics) values += metric.value.has_value();
  EXPECT_GE(values, open_channel ? 8 : 20) << "too little to compare";
  for (const int n : {-4, -2, 2, 4, 6}) {
    const double size = std::ldexp(1.0, n);
    const solver::Result copy = run(event(size, open_channel));
    ASSERT_EQ(copy.status, solver::Status::ok) << copy.reason;
    EXPECT_EQ(copy.stop_reason, one.stop_reason) << size;
    EXPECT_EQ(copy.statistics.steps, one.statistics.steps) << size;
    ASSERT_EQ(copy.metrics.size(), one.metrics.size());
    for (std::size_t k = 0; k < one.metrics.size(); ++k) {
      const solver::Metric &a = one.metrics[k], &b = copy.metrics[k];
      ASSERT_EQ(a.value.has_value(), b.value.has_value()) << a.key << " at " << size;
      EXPECT_EQ(a.absent_reason, b.absent_reason) << a.key << " at " << size;
      if (!a.value) continue;
      const double scale = factor(math::unit_of(a.key).plain, size);
      EXPECT_NEAR(*b.value, *a.value * scale, 1e-9 * std::abs(*a.value * scale))
          << a.key << " at " << size;
    }
  }
}

// H10-D45 with the fluid of Table 1 and forty times the length: not the same bits any more, and the
// flow is chaotic after the impact, so means over lattices are compared with their scatter.
TEST(ScalingOfTheFlume, FortyTimesTheFlumeWithinTheScatterOfLattices) {
  constexpr double size = 40.0;
  constexpr int lattices = 4;
  const auto runs = [&](double s) {
    std::vector<solver::Result> results;
    for (int lattice = 0; lattice < lattices; ++lattice) {
      Json json = event(s, false);
      const double n = 0.795;
      json["material"]["density_kg_m3"] = 1135;
      json["material"]["flow_index"] = n;
      json["material"]["consistency_pa_sn"] = 4.526 * std::pow(s, 1.0 + 0.5 * n);
      json["numerics"]["lattice_jitter"] = 0.01;
      json["numerics"]["lattice_seed"] = lattice + 1;
      results.push_back(run(json));
      EXPECT_EQ(results.back().stop_reason, solver::StopReason::metrics_final);
    }
    return results;
  };
  const std::vector<solver::Result> flume = runs(1.0), valley = runs(size);
  int compared = 0;
  for (std::size_t k = 0; k < flume.front().metrics.size(); ++k) {
    const std::string& key = flume.front().metrics[k].key;
    const double scale = factor(math::unit_of(key).plain, size);
    std::vector<double> mean(2, 0.0), square(2, 0.0);
    bool complete = true;
    for (int lattice = 0; lattice < lattices; ++lattice) {
      const auto at = static_cast<std::size_t>(lattice);
      const auto &a = flume[at].metrics[k].value, &b = valley[at].metrics[k].value;
      complete = complete && a && b;
      if (!complete) break;
      for (const auto& [side, value] : {std::pair{0U, *a}, std::pair{1U, *b / scale}}) {
        mean[side] += value / lattices;
        square[side] += value * value / lattices;
      }
    }
    if (!complete) continue;
    ++compared;
    const auto variance = [&](std::size_t side) {
      return std::max(0.0, square[side] - mean[side] * mean[side]) * lattices / (lattices - 1.0);
    };
    // the means' difference has this standard deviation; four of them, and the last digits of what
    // does not scatter at all
    const double deviation = std::sqrt((variance(0) + variance(1)) / lattices);
    EXPECT_NEAR(mean[1], mean[0], 4.0 * deviation + 2e-3 * std::abs(mean[0])) << key;
  }
  EXPECT_GE(compared, 25);
}

INSTANTIATE_TEST_SUITE_P(Channels, Scaling, testing::Values(false, true));

}  // namespace
}  // namespace parapet::designs
