// Flows against barriers of the source paper's kind, for the studies of uncertainty.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case.hpp"
#include "parapet/flow/geometry.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::validation {

// A single barrier in the paper's channel (Huang et al. 2024, Table 3).
struct SingleBarrier {
  const char* key;
  const char* name;
  double height;     // [m]
  double angle_deg;  // of the deflector above the horizontal; bare: none
};
constexpr double bare = -1e9;  // instead of a deflector's angle

solver::Scene scene_of(const SingleBarrier& barrier);

// Bed and barriers as lines, for pictures.
std::vector<solver::Face> outlines(const solver::Scene& scene);

// Simulates until no metric can change any more, with frames until all is at rest. Throws
// std::runtime_error with the reason when the run fails.
solver::Result simulated(const solver::Scene& scene, const solver::Numerics& numerics,
                         const CaseRun& run, double frame_interval = 0.0,
                         const std::function<void(const solver::Frame&)>& on_frame = {});

// The same with options of its own.
solver::Result simulated(const solver::Scene& scene, const solver::Numerics& numerics,
                         const solver::RunOptions& options, const CaseRun& run,
                         const std::function<void(const solver::Frame&)>& on_frame = {});

// A metric's value; not a number where the result has none.
double metric(const solver::Result& result, const std::string& key);

// What designs are judged by.
struct JudgedMetric {
  const char* key;   // in results
  const char* name;  // in words
  const char* unit;
  double scale;  // from SI to the unit
};
inline constexpr JudgedMetric judged_metrics[] = {
    {"retention_efficiency", "retention", "", 1.0},
    {"launch_length_m", "launch length", "mm", 1e3},
    {"barrier_1_design_force_n_per_m", "design force", "N/m", 1.0},
};

// Mean and standard deviation of a metric over the runs that have it, in the metric's unit.
struct Spread {
  double mean, deviation;
  std::size_t runs;
};

// None with fewer than two such runs.
std::optional<Spread> spread(std::span<const solver::Result> results, const JudgedMetric& judged);

// What scatter and resolution are shown by.
inline constexpr SingleBarrier three_barriers[] = {{"bare", "bare 100 mm", 0.1, bare},
                                                   {"d0", "0 deg deflector", 0.1, 0.0},
                                                   {"d45", "45 deg deflector", 0.1, 45.0}};

}  // namespace parapet::validation
