// A sweep of one's own: the angle of the deflector from 0 to 75 degrees, a table to stdout.
//
//   deflector_sweep [SPACING_MM]     particle spacing; 20 mm (coarse, seconds) unless given
//
// Link parapet::solver. Read one_design.cpp first.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "parapet/solver/simulation.hpp"

namespace solver = parapet::solver;

// One row of the table: a design, and what the simulation said about it.
struct Row {
  std::optional<double> angle_deg;  // no angle: the stem without a deflector
  solver::Result result;
};

// A barrier of 100 mm; with an angle it carries a deflector of 65 mm.
static solver::Scene scene_with(std::optional<double> angle_deg) {
  solver::Scene scene;
  solver::Barrier barrier;
  if (angle_deg) {
    barrier.deflector = solver::Deflector{.angle = *angle_deg * std::numbers::pi / 180.0};
  }
  scene.barriers.push_back(barrier);
  return scene;
}

// Simulations share nothing, so any number of them may run side by side. Here thread t of n takes
// the rows t, t + n, t + 2 n, ...; each row gives the same bits whatever the order.
static void simulate_all(std::vector<Row>& rows, double spacing) {
  solver::Numerics numerics;
  numerics.spacing = spacing;

  const std::size_t n_threads = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> threads;
  for (std::size_t t = 0; t < n_threads; ++t) {
    threads.emplace_back([&rows, &numerics, t, n_threads] {
      for (std::size_t i = t; i < rows.size(); i += n_threads) {
        rows[i].result = solver::simulate(scene_with(rows[i].angle_deg), numerics, {});
      }
    });
  }
}  // a std::jthread waits for its work when it goes out of scope

// A metric with three digits, or a dash where it does not exist (nothing was launched).
static std::string cell(const solver::Result& result, const char* key) {
  const solver::Metric* metric = result.find_metric(key);
  if (metric == nullptr || !metric->value) return "-";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", *metric->value);
  return text.data();
}

int main(int argc, char** argv) try {
  const double spacing = (argc > 1 ? std::atof(argv[1]) : 20.0) / 1000.0;

  std::vector<Row> rows;
  rows.push_back({std::nullopt, {}});
  for (double angle = 0.0; angle <= 75.0; angle += 15.0) rows.push_back({angle, {}});
  simulate_all(rows, spacing);

  // The columns are metrics; docs/metrics.md says what each of them means.
  const std::array columns{"retention_efficiency", "launch_length_m",
                           "barrier_1_design_force_n_per_m"};
  std::printf("%-10s", "angle_deg");
  for (const char* column : columns) std::printf(" %30s", column);
  std::printf("\n");
  for (const Row& row : rows) {
    if (row.result.status != solver::Status::ok) {
      std::printf("failed: %s\n", row.result.reason.c_str());
      return 1;
    }
    std::printf("%-10s", row.angle_deg ? std::to_string(int(*row.angle_deg)).c_str() : "none");
    for (const char* column : columns) std::printf(" %30s", cell(row.result, column).c_str());
    std::printf("\n");
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
