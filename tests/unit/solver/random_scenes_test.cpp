// Random scenes, none chosen by hand: what must hold of every run. PARAPET_RANDOM_SCENES sets how
// many (six by default). The mirrored and turned frames are in the validation case `conservation`.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <random>
#include <thread>

#include "parapet/solver/simulation.hpp"

namespace parapet::solver {
namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  bool one_in(unsigned count) { return engine_() % count == 0; }

 private:
  std::mt19937 engine_;  // the same numbers with every library, unlike its distributions
};

constexpr double spacing = 0.011;

Barrier random_barrier(Dice& dice, double foot) {
  Barrier barrier;
  barrier.foot_x = foot;
  barrier.height = dice.between(0.04, 0.2);
  barrier.thickness = dice.between(0.001, 0.04);
  barrier.stem_lean = dice.between(-0.6, 0.6);
  if (!dice.one_in(3)) {
    barrier.deflector = Deflector{dice.between(-0.3, 1.4), dice.between(0.02, 0.12)};
  }
  return barrier;
}

/// Sound scenes only: what is not is thrown away, by the solver's own judgement.
Scene random_scene(Dice& dice) {
  for (;;) {
    Scene scene;
    scene.slope = dice.between(0.0, 60.0) * std::numbers::pi / 180.0;
    scene.domain_length = dice.between(0.8, 1.6);  // so that some leave it
    scene.reservoir_length = dice.between(0.25, 0.4);
    scene.reservoir_height = dice.between(0.2, 0.35);
    scene.wall_slip = dice.one_in(3) ? WallSlip::free_slip : WallSlip::no_slip;
    scene.material.yield_stress = dice.one_in(4) ? 0.0 : std::exp(dice.between(1.0, 7.5));
    scene.material.consistency = std::exp(dice.between(-4.0, 4.0));
    scene.material.flow_index = dice.between(0.3, 1.2);
    scene.barriers = {random_barrier(dice, dice.between(0.42, 0.6))};
    if (dice.one_in(2)) scene.barriers.push_back(random_barrier(dice, dice.between(0.6, 0.8)));
    if (scene_errors(scene).empty()) return scene;
  }
}

Result run(const Scene& scene, int threads) {
  Numerics numerics;
  numerics.spacing = spacing;
  RunOptions options;
  options.stop_time = 0.45;
  options.series_interval = 0.01;
  options.settled.enabled = false;
  options.threads = threads;
  return simulate(scene, numerics, options);
}

bool same_bits(const Result& a, const Result& b) {
  if (a.status != b.status || a.series.rows.size() != b.series.rows.size()) return false;
  for (std::size_t r = 0; r < a.series.rows.size(); ++r) {
    const auto &one = a.series.rows[r], &other = b.series.rows[r];
    if (one.size() != other.size() ||
        std::memcmp(one.data(), other.data(), one.size() * sizeof(double)) != 0) {
      return false;
    }
  }
  for (std::size_t k = 0; k < a.metrics.size(); ++k) {
    if (a.metrics[k].value != b.metrics[k].value) return false;
  }
  return a.statistics.cg_iterations == b.statistics.cg_iterations &&
         a.statistics.wall_contacts == b.statistics.wall_contacts;
}

void expect_sound(const Result& result) {
  EXPECT_TRUE(result.status == Status::ok || !result.reason.empty());
  // a sum of a thousand masses that exchange some of it: relative rounding 1e-13
  EXPECT_NEAR(result.mass.in_domain + result.mass.left_domain, result.mass.released,
              1e-12 * result.mass.released);
  EXPECT_EQ(result.statistics.max_particles_inside_walls, 0);
  for (const Metric& metric : result.metrics) {
    EXPECT_EQ(metric.value.has_value(), metric.absent_reason.empty()) << metric.key;
    EXPECT_TRUE(std::isfinite(metric.value.value_or(0.0))) << metric.key;
  }
}

int scene_count() {
  const char* text = std::getenv("PARAPET_RANDOM_SCENES");  // NOLINT(concurrency-mt-unsafe)
  return text == nullptr ? 6 : std::atoi(text);
}

TEST(RandomScenes, KeepMassAndBitsWhateverRunsThem) {
  for (int n = 1; n <= scene_count(); ++n) {
    SCOPED_TRACE("scene " + std::to_string(n));
    Dice dice(static_cast<unsigned>(n));
    const Scene scene = random_scene(dice);
    const Result alone = run(scene, 1);
    ASSERT_GT(alone.mass.particles_released, 380) << "two threads would have nothing to share";
    expect_sound(alone);
    EXPECT_TRUE(same_bits(alone, run(scene, 2)));
    EXPECT_TRUE(same_bits(alone, run(scene, 4)));
    // Beside another simulation that began before it, in the same process.
    const Scene another = random_scene(dice);
    std::thread other([&] { run(another, 1); });
    const Result beside = run(scene, 1);
    other.join();
    EXPECT_TRUE(same_bits(alone, beside));
  }
}

}  // namespace
}  // namespace parapet::solver
