// What a result says against itself.
#include "gauges/quality.hpp"

#include <gtest/gtest.h>

#include "placed_particles.hpp"

namespace parapet::solver {
namespace {

TEST(EnergyGain, IsTheLargestRiseAboveTheLowestSoFar) {
  EnergyGain gain;
  for (const double energy : {-5.0, -7.0, -6.5, -9.0, -8.75}) gain.observe(energy);
  EXPECT_DOUBLE_EQ(gain.largest(), 0.5);
}

TEST(SprayShare, IsTheMassThatHasComeOffTheFluid) {
  Fluid f = fluid_of({{0.0, 0.0, 3.0}, {0.1, 0.0, 1.0}});
  f.lambda[0] = 0.9;
  f.lambda[1] = 0.5;
  EXPECT_DOUBLE_EQ(spray_share(f), 0.25);
  EXPECT_EQ(spray_share(fluid_of({})), 0.0);
}

// One droplet in the slam of a barrier is no verdict on a run; a hundredth of the mass is.
TEST(DensityError, IsTheOneThatAShareOfTheMassExceeds) {
  Fluid f = fluid_of({{0.0, 0.0, 0.5}, {0.1, 0.0, 98.0}, {0.2, 0.0, 0.75}, {0.3, 0.0, 0.75}});
  f.density = {1300.0, 1010.0, 950.0, 1080.0, 1.0};
  EXPECT_NEAR(density_error(f, 1000.0, 0.0), 0.3, 1e-12) << "the largest of all";
  EXPECT_NEAR(density_error(f, 1000.0, 0.01), 0.08, 1e-12) << "0.5 of 100 kg/m is beyond it";
  EXPECT_NEAR(density_error(f, 1000.0, 0.0124), 0.08, 1e-12);
  EXPECT_NEAR(density_error(f, 1000.0, 0.0126), 0.05, 1e-12) << "compressed and stretched alike";
  EXPECT_EQ(density_error(fluid_of({}), 1000.0, 0.01), 0.0);
}

TEST(MassSpread, IsTheCoefficientOfVariation) {
  EXPECT_DOUBLE_EQ(mass_spread(fluid_of({{0.0, 0.0, 0.9}, {0.1, 0.0, 1.1}})), 0.1);
  EXPECT_EQ(mass_spread(fluid_of({{0.0, 0.0, 0.9}})), 0.0);
}

TEST(Warnings, NameEveryLimitThatIsNotKept) {
  Quality sound;
  sound.particles_across_approach = 4.0;
  EXPECT_TRUE(warnings_of(sound, false, 6.0).empty());
  Quality poor{0.06, 0.3, 0.16, 0.61, 1.1, 3.9, 0.11};
  const std::vector<Warning> warnings = warnings_of(poor, true, 6.0);
  std::vector<std::string> keys;
  for (const Warning& warning : warnings) {
    keys.push_back(warning.key);
    EXPECT_FALSE(warning.text.empty());
  }
  EXPECT_EQ(keys, (std::vector<std::string>{
                      "energy_gain_ratio", "density_error_bulk", "mass_spread", "spray_share_max",
                      "wall_contacts_per_particle", "particles_across_approach", "stop_time"}));
  EXPECT_EQ(warnings[1].value, 0.11);
  EXPECT_EQ(warnings[1].limit, QualityLimits::density_error_bulk);
  poor.particles_across_approach.reset();
  EXPECT_EQ(warnings_of(poor, false, 6.0).size(), 5U) << "none arrived, and nothing was cut off";
}

}  // namespace
}  // namespace parapet::solver
