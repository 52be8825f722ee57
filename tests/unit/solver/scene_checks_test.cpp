// Impossible input is refused with a sentence that names the field, its value and what is allowed.
#include <gtest/gtest.h>

#include <functional>

#include "parapet/solver/simulation.hpp"

namespace parapet::solver {
namespace {

struct WrongScene {
  const char* words;
  std::function<void(Scene&)> spoil;
};

TEST(SceneChecks, NameWhatIsWrong) {
  const WrongScene cases[] = {
      {"material density is 0", [](Scene& s) { s.material.density = 0.0; }},
      {"flow index is -1", [](Scene& s) { s.material.flow_index = -1.0; }},
      {"cut-off shear rate is 0", [](Scene& s) { s.material.cutoff_shear_rate = 0.0; }},
      {"slope is 1.5", [](Scene& s) { s.slope = 1.5; }},
      {"reservoir height is 0", [](Scene& s) { s.reservoir_height = 0.0; }},
      {"domain length is 0.2", [](Scene& s) { s.domain_length = 0.2; }},
      {"barrier 1 height is -0.1", [](Scene& s) { s.barriers[0].height = -0.1; }},
      {"barrier 1 foot is 0.1", [](Scene& s) { s.barriers[0].foot_x = 0.1; }},
      {"barrier 2 reaches upstream",
       [](Scene& s) {
         s.barriers.push_back(s.barriers[0]);
         s.barriers[1].foot_x = 1.11;
       }},
      {"deflector angle is 3",
       [](Scene& s) {
         s.barriers[0].deflector = Deflector{3.0, 0.065};
       }},
      {"lowest corner above the bed",
       [](Scene& s) {
         s.barriers[0].height = 0.02;
         s.barriers[0].deflector = Deflector{-0.6, 0.2};
       }},
      {"counter-clockwise",
       [](Scene& s) {
         s.solids = {{{{1, 0}, {1, 1}, {2, 0}}}};
       }},
  };
  for (const WrongScene& wrong : cases) {
    Scene scene;
    scene.barriers.push_back({});
    ASSERT_TRUE(scene_errors(scene).empty());
    wrong.spoil(scene);
    const auto errors = scene_errors(scene);
    ASSERT_FALSE(errors.empty()) << wrong.words;
    EXPECT_NE(errors.front().find(wrong.words), std::string::npos) << errors.front();
    EXPECT_THROW(simulate(scene, {}, {}), std::invalid_argument);
  }
}

TEST(SceneChecks, NumericsAndRunOptions) {
  Numerics numerics;
  numerics.spacing = -1.0;
  numerics.cg_max_iterations = 0;
  numerics.steps_per_solve = 0;
  numerics.sound_speed_floor = 1.1;
  EXPECT_EQ(numerics_errors(numerics).size(), 4u);
  RunOptions options;
  options.threads = 0;
  ASSERT_EQ(run_errors(options).size(), 1u);
  EXPECT_NE(run_errors(options)[0].find("threads is 0"), std::string::npos);
}

}  // namespace
}  // namespace parapet::solver
