// The table of metrics and its gauges, on readings made by hand.
#include "gauges/metric_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "parapet/solver/metric_catalog.hpp"

namespace parapet::solver {
namespace {

BarrierReadings hit_barrier(double retained) {
  BarrierReadings barrier;
  barrier.retained = retained;
  barrier.run_up = 0.08;
  barrier.arrival = 0.9;
  barrier.loads.peak[slam_window] = {250.0, 1.1, 12.0};
  barrier.loads.peak[short_window] = {200.0, 1.1, 10.0};
  barrier.loads.peak[design_window] = {150.0, 1.2, 8.0};
  barrier.loads.stem = 120.0;
  barrier.loads.deflector = 40.0;
  barrier.load_height = 0.06;
  barrier.impulse = 60.0;
  barrier.at_rest = BarrierLoad{{30.0, -40.0}, 1.0};
  barrier.approach = Approach{2.0, 0.05};
  return barrier;
}

RunReadings open_channel() {
  RunReadings run;
  run.event_length = 0.2;
  run.spacing = 0.005;
  run.particles = 2400.0;
  run.gravity = 9.81;
  run.slope = 0.4;
  run.density = 1000.0;
  run.released_volume = 0.06;
  run.front = {0.8, 2.0};
  run.energy = EnergyPhases{4.0, 1.0, EnergyPhases::Rise{1.0, 2.0}, 3.0};
  run.deepest = DeepestFlow{0.04, 1.2};
  return run;
}

RunReadings two_barriers() {
  RunReadings run = open_channel();
  run.deepest.reset();
  run.first_foot_x = 1.0;
  run.deflector_length = 0.05;
  run.peak_loss_rate = 0.5;
  run.dead_zone_length = 0.1;
  run.impact = LaunchGauge::Impact{1.5, 1.4, 2.5};
  run.launch = LaunchGauge::Launch{1.5, 0.5, 0.12, 1.02};
  run.barriers = {hit_barrier(0.7), hit_barrier(0.9)};
  run.instant_wanted = true;
  const HeldDebris held{.dead_zone = {.length = 0.2, .area = 0.01}, .ramp = {.angle = 0.4}};
  run.instant = InstantReadings{InstantReadings::Tongue{1.7, 1.8, false}, held.ramp};
  run.sheet = LaunchGauge::Sheet{1.2, 0.02};
  for (BarrierReadings& barrier : run.barriers) {
    barrier.held = held;
    barrier.events = {.dead_zone_onset = 1.1, .backflow = {.share = 0.1, .speed = 0.6}};
  }
  return run;
}

/// Runs of every kind: all there, and each thing that may be missing missing in one of them.
std::vector<RunReadings> runs_of_every_kind() {
  std::vector<RunReadings> runs{open_channel(), two_barriers()};
  RunReadings dry;
  dry.particles = 2400.0;
  dry.deepest = DeepestFlow{0.0, 0.0};  // nothing came to the monitored place
  runs.push_back(dry);
  dry.unfinished = true;
  runs.push_back(dry);
  RunReadings nothing;
  nothing.barriers.resize(2);
  nothing.particles = 2400.0;
  RunReadings cut_off = runs.emplace_back(nothing);
  cut_off.unfinished = true;
  runs.push_back(cut_off);
  cut_off.barriers.clear();
  runs.push_back(cut_off);
  runs.emplace_back(two_barriers()).launch.reset();  // it landed, but passed by the edge
  RunReadings early = two_barriers();
  early.instant = InstantReadings{};
  early.barriers[0].impulse.reset();
  early.barriers[0].approach = Approach{};  // without barriers the flow stops before it
  runs.push_back(early);
  const Ramp coarse_ramp{.angle = {}, .too_coarse = true};
  early.instant->ramp = coarse_ramp;
  early.barriers[0].held->ramp = coarse_ramp;
  runs.push_back(early);
  early.instant.reset();
  runs.push_back(early);
  runs.push_back(nothing);
  for (const std::size_t full : {0U, 1U}) {
    RunReadings still = runs[full];
    still.energy->rise.reset();
    still.energy->plateau_time.reset();
    runs.push_back(still);
    still.unfinished = true;
    runs.push_back(still);
    RunReadings coarse = runs[full];
    coarse.spacing = 0.05;
    runs.push_back(coarse);
    coarse.spacing = 0.005;
    coarse.particles = 100.0;
    runs.push_back(coarse);
  }
  return runs;
}

std::map<std::string, Metric> by_key(const std::vector<Metric>& metrics) {
  std::map<std::string, Metric> map;
  for (const Metric& metric : metrics) map[metric.key] = metric;
  return map;
}

TEST(MetricTable, AMetricThatCreepsMayMoveALittleAndOthersNotAtAll) {
  const RunReadings before = two_barriers();
  EXPECT_FALSE(metric_moved(before, before, 0.002));
  RunReadings now = before;
  now.barriers[1].retained -= 0.0019;
  now.dead_zone_length += 0.0019;  // the barrier is 1 m away
  EXPECT_FALSE(metric_moved(before, now, 0.002));
  now.barriers[1].retained = before.barriers[1].retained - 0.0021;
  EXPECT_TRUE(metric_moved(before, now, 0.002));
  now = before;
  now.barriers[0].loads.peak[slam_window].force += 1e-9;
  EXPECT_TRUE(metric_moved(before, now, 0.002)) << "a larger peak";
  now = before;
  now.energy->plateau_time.reset();
  EXPECT_TRUE(metric_moved(before, now, 0.002)) << "a value that is gone";
  EXPECT_TRUE(metric_moved(now, before, 0.002)) << "and one that has come";
}

TEST(MetricTable, EveryKeyStandsOnce) {
  std::set<std::string> keys;
  for (const MetricInfo& info : metric_catalog(2)) {
    EXPECT_TRUE(keys.insert(info.key).second) << info.key << " stands twice";
    EXPECT_LT(info.least, info.greatest) << info.key;
  }
  for (const MetricEntry& entry : metric_table().each_barrier) {
    EXPECT_TRUE(entry.key.starts_with(barrier_placeholder)) << entry.key;
  }
}

TEST(MetricTable, ResultsAndCatalogueHoldTheSameKeysInTheSameOrder) {
  for (const RunReadings& run : runs_of_every_kind()) {
    const auto catalog = metric_catalog(static_cast<int>(run.barriers.size()));
    const auto metrics = read_metrics(run);
    ASSERT_EQ(metrics.size(), catalog.size());
    for (std::size_t k = 0; k < metrics.size(); ++k) EXPECT_EQ(metrics[k].key, catalog[k].key);
  }
}

/// A gauge gives a value in the entry's range or one of the entry's reasons, and each reason that
/// the entry names comes from its gauge.
TEST(MetricTable, GaugesKeepTheRangeAndTheReasonsOfTheirEntry) {
  std::map<std::string, std::set<std::string>> unused;
  for (const MetricInfo& info : metric_definitions()) {
    unused[info.key] = {info.absent_when.begin(), info.absent_when.end()};
  }
  for (const RunReadings& run : runs_of_every_kind()) {
    for_each_metric(run.barriers.size(),
                    [&](const std::string& key, const MetricEntry& entry, std::size_t barrier) {
                      const Reading reading = read(entry, run, barrier);
                      ASSERT_EQ(reading.value.has_value(), reading.absent == nullptr) << key;
                      if (reading.value) {
                        EXPECT_GE(*reading.value, entry.least) << key;
                        EXPECT_LE(*reading.value, entry.greatest) << key;
                        return;
                      }
                      EXPECT_EQ(std::ranges::count(absent_when(entry), reading.absent), 1)
                          << key << ": " << reading.absent->text;
                      unused[std::string(entry.key)].erase(std::string(reading.absent->text));
                    });
  }
  for (const auto& [key, reasons] : unused) {
    EXPECT_TRUE(reasons.empty()) << key << " is never absent because: " << *reasons.begin();
  }
}

TEST(MetricTable, GaugesReadWhatTheirEntriesDefine) {
  auto metrics = by_key(read_metrics(two_barriers()));
  const auto value = [&](const char* key) { return metrics.at(key).value.value(); };
  EXPECT_EQ(value("retention_efficiency"), 0.7);
  EXPECT_EQ(value("retention_efficiency_total"), 0.9);
  EXPECT_EQ(value("barrier_2_retention_efficiency"), 0.9);
  EXPECT_NEAR(value("launch_length_m"), 0.4, 1e-15);
  EXPECT_EQ(value("impact_x_m"), 1.4);
  EXPECT_NEAR(value("launch_angle_deg"), 0.5 * 180.0 / 3.14159265358979, 1e-12);
  EXPECT_NEAR(value("dead_zone_ratio"), 2.0, 1e-15);
  EXPECT_NEAR(value("overflow_volume_m3_per_m"), 0.3 * 0.06, 1e-15);
  EXPECT_NEAR(value("barrier_2_overtopping_volume_m3_per_m"), 0.1 * 0.06, 1e-15);
  EXPECT_NEAR(value("peak_overflow_discharge_m2_s"), 0.5 * 0.06, 1e-15);
  EXPECT_EQ(value("kinetic_energy_minimum_j_per_m"), 1.0);
  EXPECT_EQ(value("kinetic_energy_overflow_peak_j_per_m"), 2.0);
  EXPECT_EQ(value("barrier_1_slam_moment_nm_per_m"), 12.0);
  EXPECT_EQ(value("barrier_2_design_force_n_per_m"), 150.0);
  EXPECT_EQ(value("barrier_2_design_force_time_s"), 1.2);
  EXPECT_EQ(value("barrier_1_design_moment_nm_per_m"), 8.0);
  EXPECT_EQ(value("barrier_1_short_window_force_n_per_m"), 200.0);
  EXPECT_EQ(value("barrier_1_stem_design_force_n_per_m"), 120.0);
  EXPECT_EQ(value("barrier_1_deflector_design_force_n_per_m"), 40.0);
  EXPECT_EQ(value("barrier_1_design_load_height_m"), 0.06);
  EXPECT_EQ(value("barrier_1_impulse_n_s_per_m"), 60.0);
  EXPECT_DOUBLE_EQ(value("barrier_1_hydrodynamic_coefficient"), 150.0 / (1000.0 * 4.0 * 0.05));
  EXPECT_DOUBLE_EQ(value("barrier_1_hydrostatic_coefficient"),
                   150.0 / (0.5 * 1000.0 * 9.81 * 0.05 * 0.05));
  EXPECT_DOUBLE_EQ(value("barrier_1_static_force_n_per_m"), 50.0);
  EXPECT_EQ(value("launch_tip_x_m"), 1.7);
  EXPECT_EQ(value("launch_tip_landed"), 0.0);
  EXPECT_EQ(value("launch_farthest_x_m"), 1.8);
  EXPECT_NEAR(value("ramp_angle_deg"), 0.4 * 180.0 / 3.14159265358979, 1e-12);
  EXPECT_FALSE(metrics.at("flow_depth_max_m").value);

  metrics = by_key(read_metrics(open_channel()));
  EXPECT_NEAR(value("froude_number"), 2.0 / std::sqrt(9.81 * std::cos(0.4) * 0.04), 1e-14);
  EXPECT_FALSE(metrics.contains("retention_efficiency"));
}

TEST(MetricTable, WhatTheParticlesDoNotResolveIsAbsentForThatReason) {
  RunReadings run = two_barriers();
  const auto absence = [&](const char* key) { return by_key(read_metrics(run)).at(key).absence; };
  run.spacing = 0.0050001;  // four across the 20 mm of a dead zone's column
  EXPECT_EQ(absence("dead_zone_length_m"), Absence::too_coarse);
  EXPECT_EQ(absence("barrier_2_arrival_time_s"), Absence::too_coarse);
  EXPECT_EQ(absence("retention_efficiency"), Absence::none);
  EXPECT_EQ(absence("launch_length_m"), Absence::none);
  EXPECT_EQ(absence("flow_depth_max_m"), Absence::does_not_exist) << "whatever the particles";
  run.settings.dead_zone_window_ratio = 0.2;
  EXPECT_EQ(absence("dead_zone_length_m"), Absence::none);
  run.spacing = 0.005;
  run.particles = 1999.0;  // a thousandth of them is not two
  EXPECT_EQ(absence("barrier_1_run_up_height_m"), Absence::too_coarse);
  EXPECT_EQ(absence("arrival_time_s"), Absence::none);
}

TEST(MetricTable, ALongerRunCouldBringWhatIsOnlyNotThereYet) {
  RunReadings run = two_barriers();
  run.impact.reset();
  run.launch.reset();
  run.deflector_length.reset();
  const auto absence = [&](const char* key) { return by_key(read_metrics(run)).at(key).absence; };
  EXPECT_EQ(absence("launch_length_m"), Absence::does_not_exist);
  run.unfinished = true;
  EXPECT_EQ(absence("launch_length_m"), Absence::run_too_short);
  EXPECT_EQ(absence("dead_zone_ratio"), Absence::does_not_exist) << "no deflector grows";
  EXPECT_EQ(absence("retention_efficiency"), Absence::none);
}

TEST(MetricCatalog, FindsKeysOfAnyBarrier) {
  const auto force = find_metric_info("barrier_12_slam_force_n_per_m");
  ASSERT_TRUE(force);
  EXPECT_EQ(force->key, "barrier_12_slam_force_n_per_m");
  EXPECT_EQ(force->unit, "N/m");
  EXPECT_EQ(force->least, 0.0);
  EXPECT_FALSE(force->may_not_exist);
  EXPECT_TRUE(find_metric_info("launch_length_m")->may_not_exist);
  EXPECT_FALSE(find_metric_info("dead_zone_length_m")->may_not_exist);
  EXPECT_FALSE(find_metric_info("dead_zone_length_m")->absent_when.empty()) << "coarse particles";
  for (const MetricInfo& info : metric_catalog(3)) {
    EXPECT_EQ(find_metric_info(info.key)->definition, info.definition) << info.key;
  }
  for (const char* wrong :
       {"", "barrier_0_arrival_time_s", "barrier_arrival_time_s", "barrier_K_arrival_time_s",
        "barrier_01_arrival_time_s", "barrier_1_launch_length_m", "slam_force_n_per_m"}) {
    EXPECT_FALSE(find_metric_info(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace parapet::solver
