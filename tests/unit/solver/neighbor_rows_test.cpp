// Neighbour rows against brute force, and the separation of a plate's two sides at every spacing.
#include "parapet/flow/neighbor_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "parapet/flow/channel.hpp"
#include "parapet/flow/step_rows.hpp"

namespace parapet::solver {
namespace {

// The rows of pairs nearer than `reach`, as a step picks them.
struct PickedRows {
  StepRows rows;
  RowView view;
  PickedRows(Fluid& fluid, WallPoints walls, const NeighborRows& near, double reach,
             double period = 0.0, const PassTable& passes = best_passes()) {
    FlowConstants constants{};
    constants.smoothing_length = 0.5 * reach;
    constants.periodic_length = period;
    fluid.pack(0, fluid.n + 1);
    rows.pick(passes, {constants, fluid.view(), walls.view(), {}}, near, 1);
    view = rows.view(near);
  }
};

std::set<std::int32_t> row_of(const RowView& rows, std::int32_t from, std::int32_t to, int i,
                              std::int32_t ghost) {
  std::set<std::int32_t> row;
  bool ended = false;
  for (int s = from + i % lanes; s < to; s += lanes) {
    if (rows.index[s] == ghost) {
      ended = true;
      continue;
    }
    EXPECT_FALSE(ended) << "ghosts come last";
    EXPECT_TRUE(row.insert(rows.index[s]).second) << "twice in the row of " << i;
  }
  return row;
}

std::set<std::int32_t> fluid_row(const RowView& rows, int i, int ghost) {
  return row_of(rows, rows.begin[i / lanes], rows.wall_begin[i / lanes], i, ghost);
}

std::set<std::int32_t> wall_row(const RowView& rows, int i, const WallPoints& walls) {
  return row_of(rows, rows.wall_begin[i / lanes], rows.end[i / lanes], i,
                static_cast<std::int32_t>(walls.size()));
}

TEST(NeighborRows, HoldEveryPairWithinTheReachAndNoneTwice) {
  std::vector<InitialParticle> particles;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 0.2);
  for (int k = 0; k < 700; ++k) particles.push_back({place(random), place(random), 0, 0, 1000, 1});
  Fluid fluid;
  fluid.assign(particles);
  const Solids none;
  const WallPoints no_walls;
  NeighborRows rows(none, no_walls, 0.02, 0.004, 0.01, 0.0);
  rows.build(fluid, 1);
  const PickedRows picked(fluid, no_walls, rows, 0.024);
  const RowView& view = picked.view;
  for (int i = 0; i < fluid.n; ++i) {
    std::set<std::int32_t> expected;
    for (int j = 0; j < fluid.n; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const double r = std::hypot(fluid.x[a] - fluid.x[b], fluid.z[a] - fluid.z[b]);
      if (j != i && r < 0.024) expected.insert(j);
    }
    EXPECT_EQ(fluid_row(view, i, fluid.n), expected);
    EXPECT_EQ((view.wall_begin[i / lanes] - view.begin[i / lanes]) % lanes, 0);
  }
}

std::set<std::int32_t> expected_row(const Fluid& fluid, int i, double reach, double period) {
  std::set<std::int32_t> expected;
  for (int j = 0; j < fluid.n; ++j) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    double rx = fluid.x[a] - fluid.x[b];
    if (period > 0.0) rx -= period * std::round(rx / period);
    if (j != i && std::hypot(rx, fluid.z[a] - fluid.z[b]) < reach) expected.insert(j);
  }
  return expected;
}

// What a flow relies on: whatever has moved since the build, no pair within the reach is missing,
// in any instruction set, near a body and away from it.
TEST(NeighborRows, HoldEveryPairWithinTheReachUntilTheyAreOutdated) {
  Scene scene;
  Barrier barrier;
  barrier.height = 0.1;
  barrier.stem_lean = -scene.slope;  // straight up in these axes: it hides no pair of those below
  scene.barriers = {barrier};
  Numerics numerics;
  numerics.spacing = 0.01;
  const FlowSetup setup = channel_setup(scene, numerics, 1);
  const WallPoints walls = lay_out_walls(setup.solids, 0.01, 0.02);
  const double foot = barrier.foot_x;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> along(foot - 0.25, foot - 0.03), up(0.02, 0.2);
  std::uniform_real_distribution<double> step(-0.0004, 0.0004);
  std::vector<InitialParticle> particles;
  for (int k = 0; k < 701; ++k) particles.push_back({along(random), up(random), 0, 0, 1000, 1});
  Fluid fluid;
  fluid.assign(particles);
  NeighborRows rows(setup.solids, walls, 0.02, 0.004, 0.01, 0.0);
  rows.build(fluid, 1);
  int checked = 0;
  for (; !rows.outdated(fluid); ++checked) {
    for (const char* name : {"x86_64", "x86_64_v3", "x86_64_v4"}) {
      const PassTable* passes = find_passes(name);
      if (passes == nullptr) continue;  // not this machine's
      const PickedRows picked(fluid, walls, rows, 0.02, 0.0, *passes);
      for (int i = 0; i < fluid.n; ++i) {
        ASSERT_EQ(fluid_row(picked.view, i, fluid.n), expected_row(fluid, i, 0.02, 0.0)) << name;
      }
    }
    for (std::size_t i = 0; i < particles.size(); ++i) {
      fluid.x[i] += step(random);
      fluid.z[i] += step(random);
    }
  }
  EXPECT_GE(checked, 3);
}

// Particles in clear air need no look at the faces; that must never hide a crossing.
TEST(NeighborRows, AreClearOfFacesOnlyWhereNoneIsCrossed) {
  Scene scene;
  Barrier barrier;
  barrier.deflector = Deflector{0.785, 0.065};
  scene.barriers = {barrier};
  Numerics numerics;
  numerics.spacing = 0.01;
  const FlowSetup setup = channel_setup(scene, numerics, 1);
  const WallPoints walls = lay_out_walls(setup.solids, 0.01, 0.0266);
  std::vector<int> all;
  for (std::size_t f = 0; f < setup.solids.faces.size(); ++f) all.push_back(static_cast<int>(f));
  std::mt19937 random(6);
  std::uniform_real_distribution<double> along(barrier.foot_x - 0.1, barrier.foot_x + 0.1);
  std::uniform_real_distribution<double> up(0.0005, 0.2), move(-0.01, 0.01);
  std::vector<InitialParticle> particles;
  for (int k = 0; k < 4000; ++k) particles.push_back({along(random), up(random), 0, 0, 1000, 1});
  Fluid fluid;
  fluid.assign(particles);
  NeighborRows rows(setup.solids, walls, 0.0266, 0.009, 0.01, 0.0);
  rows.build(fluid, 1);
  int clear = 0, crossing = 0;
  for (int i = 0; i < fluid.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vec2 built{fluid.x[k], fluid.z[k]};
    const Vec2 from = built + Vec2{move(random), move(random)};
    const Vec2 to = built + Vec2{move(random), move(random)};
    const bool crossed = first_crossed(setup.solids.faces, all, from, to) >= 0;
    crossing += crossed;
    if (!rows.clear_of_faces(i, from, to)) continue;
    ++clear;
    EXPECT_FALSE(crossed) << built.x << ", " << built.z;
  }
  EXPECT_GT(clear, 500);
  EXPECT_GT(crossing, 100);
}

// Cells over the box that holds these would be 10^14: only those with particles are kept.
TEST(NeighborRows, EmptySpaceBetweenTheParticlesCostsNothing) {
  std::vector<InitialParticle> particles;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(0.0, 0.1);
  for (const auto& [x, z] : {std::pair(0.0, 0.0), std::pair(2e5, 1e5), std::pair(-1e5, 3e5)}) {
    for (int k = 0; k < 150; ++k) {
      particles.push_back({x + place(random), z + place(random), 0, 0, 1000, 1});
    }
  }
  Fluid fluid;
  fluid.assign(particles);
  const Solids none;
  const WallPoints no_walls;
  NeighborRows rows(none, no_walls, 0.02, 0.004, 0.01, 0.0);
  rows.build(fluid, 2);
  const PickedRows picked(fluid, no_walls, rows, 0.024);
  for (int i = 0; i < fluid.n; ++i) {
    EXPECT_EQ(fluid_row(picked.view, i, fluid.n), expected_row(fluid, i, 0.024, 0.0));
  }
  EXPECT_FALSE(rows.outdated(fluid));
}

TEST(NeighborRows, SeeThroughThePeriodicEnds) {
  for (const double period : {0.075, 0.1, 0.3}) {  // three, four and twelve cells
    std::vector<InitialParticle> particles;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (int k = 0; k < 300; ++k) {
      particles.push_back({period * place(random), 0.1 * place(random), 0, 0, 1000, 1});
    }
    Fluid fluid;
    fluid.assign(particles);
    const Solids none;
    const WallPoints no_walls;
    NeighborRows rows(none, no_walls, 0.02, 0.004, 0.01, period);
    rows.build(fluid, 1);
    const PickedRows picked(fluid, no_walls, rows, 0.024, period);
    for (int i = 0; i < fluid.n; ++i) {
      EXPECT_EQ(fluid_row(picked.view, i, fluid.n), expected_row(fluid, i, 0.024, period));
    }
  }
}

// A channel of 1000 m by 500 m has 6 * 10^8 cells of 30 mm; those along its walls are 10^5.
TEST(WallCells, HoldEveryFaceNearAPlaceHoweverLargeTheChannel) {
  Scene scene;
  scene.domain_length = 1000.0;
  scene.domain_height = 500.0;
  Barrier barrier;
  barrier.deflector = Deflector{0.785, 0.065};
  scene.barriers = {barrier};
  scene.solids = {{{{1.5, 0.2}, {2.5, 0.9}, {2.0, 1.0}}}};  // slanting, in clear air
  Numerics numerics;
  numerics.spacing = 0.02;
  const FlowSetup setup = channel_setup(scene, numerics, 1);
  const double reach = 0.0532, size = 0.06;
  const WallPoints walls = lay_out_walls(setup.solids, numerics.spacing, reach);
  const WallCells cells(setup.solids, walls, size);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> x(0.0, 3.0), z(0.0, 1.5);
  int near = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vec2 p{x(random), z(random)};
    const std::vector<int>& found = cells.faces_near(p);
    for (std::size_t f = 0; f < setup.solids.faces.size(); ++f) {
      const Face& face = setup.solids.faces[f];
      const double distance = distance_to_segment(face.a, face.b, p);
      if (distance <= 0.5 * size) {
        EXPECT_TRUE(cells.may_be_reached_from(p));
      }
      if (distance > size) continue;
      ++near;
      EXPECT_NE(std::find(found.begin(), found.end(), static_cast<int>(f)), found.end())
          << "face " << f << " at " << p.x << ", " << p.z;
    }
  }
  EXPECT_GT(near, 1000);
  EXPECT_TRUE(cells.faces_near({500.0, 250.0}).empty());
  EXPECT_FALSE(cells.may_be_reached_from({500.0, 250.0}));
  EXPECT_FALSE(cells.faces_near({999.9, 0.01}).empty()) << "the bed's far end";
}

TEST(NeighborRows, AreOutdatedBeforeAPairCanComeIntoReach) {
  Fluid fluid;
  const std::vector<InitialParticle> pair{{0.0, 0.0, 0, 0, 1000, 1}, {0.0241, 0.0, 0, 0, 1000, 1}};
  fluid.assign(pair);
  const Solids none;
  const WallPoints no_walls;
  NeighborRows rows(none, no_walls, 0.02, 0.004, 0.01, 0.0);
  rows.build(fluid, 1);
  fluid.x[1] -= 0.0039;
  EXPECT_FALSE(rows.outdated(fluid));
  fluid.x[1] -= 0.0003;  // now 0.0199 apart
  EXPECT_TRUE(rows.outdated(fluid));
}

TEST(NeighborRows, UniformMotionAloneDoesNotOutdateThem) {
  Fluid fluid;
  fluid.assign(lattice_block(0.0, 0.0, 0.1, 0.1, 0.01, 1000.0));
  const Solids none;
  const WallPoints no_walls;
  NeighborRows rows(none, no_walls, 0.0266, 0.003, 0.01, 0.0);
  rows.build(fluid, 1);
  for (double& x : fluid.x) x += 0.014;  // less than half a cell of 29.6 mm
  EXPECT_FALSE(rows.outdated(fluid));
}

TEST(NeighborRows, AreOutdatedBeforeSeparateClumpsMeet) {
  // two rigid clumps, far apart at the build, approach until they would overlap
  std::vector<InitialParticle> particles = lattice_block(0.0, 0.0, 0.05, 0.05, 0.01, 1000.0);
  const std::size_t first = particles.size();
  for (const auto& p : lattice_block(0.15, 0.0, 0.05, 0.05, 0.01, 1000.0)) particles.push_back(p);
  Fluid fluid;
  fluid.assign(particles);
  const Solids none;
  const WallPoints no_walls;
  NeighborRows rows(none, no_walls, 0.0266, 0.003, 0.01, 0.0);
  rows.build(fluid, 1);
  double gap = 0.10;
  while (!rows.outdated(fluid)) {
    for (std::size_t i = 0; i < particles.size(); ++i) {
      fluid.x[i] += static_cast<std::size_t>(fluid.id[i]) < first ? 0.001 : -0.001;
    }
    gap -= 0.002;
    ASSERT_GT(gap, 0.0266) << "the clumps see each other and the rows do not know";
  }
}

TEST(NeighborRows, AreOutdatedBeforeAFallingBlockReachesTheBed) {
  Scene scene;
  Numerics numerics;
  numerics.spacing = 0.01;
  const FlowSetup setup = channel_setup(scene, numerics, 1);
  Fluid fluid;
  fluid.assign(lattice_block(1.0, 0.3, 0.1, 0.1, 0.01, 1000.0));
  const WallPoints walls = lay_out_walls(setup.solids, 0.01, 0.0266);
  NeighborRows rows(setup.solids, walls, 0.0266, 0.003, 0.01, 0.0);
  rows.build(fluid, 1);
  double height = 0.305;
  while (height > 0.02) {
    for (double& z : fluid.z) z -= 0.001;
    height -= 0.001;
    if (rows.outdated(fluid)) {
      rows.build(fluid, 1);
    }
  }
  bool seen = false;
  for (int i = 0; i < fluid.n; ++i) seen = seen || rows.touches_wall(i);
  EXPECT_TRUE(seen);
}

// Fluid on both sides of a vertical plate in the middle of a tank.
class ThinPlate : public ::testing::TestWithParam<double> {};

TEST_P(ThinPlate, NothingReachesThroughIt) {
  const double dx = GetParam(), thickness = 0.015, h = 1.33 * dx;
  Scene scene;
  Barrier barrier;
  barrier.foot_x = 0.5;
  barrier.height = 0.2;
  barrier.thickness = thickness;
  barrier.stem_lean = -scene.slope;  // straight up in these axes
  scene.barriers = {barrier};
  Numerics numerics;
  numerics.spacing = dx;
  const FlowSetup setup = channel_setup(scene, numerics, 1);
  std::vector<InitialParticle> particles = lattice_block(0.5 - 6 * dx, 0, 6 * dx, 0.15, dx, 1000);
  const std::size_t upstream = particles.size();
  for (const auto& p : lattice_block(0.5 + thickness, 0, 6 * dx, 0.15, dx, 1000)) {
    particles.push_back(p);
  }
  Fluid fluid;
  fluid.assign(particles);
  const WallPoints walls = lay_out_walls(setup.solids, dx, 2.0 * h);
  NeighborRows rows(setup.solids, walls, 2.0 * h, 0.25 * h, dx, 0.0);
  rows.build(fluid, 1);
  const PickedRows picked(fluid, walls, rows, 2.25 * h);
  const RowView& view = picked.view;
  for (int i = 0; i < fluid.n; ++i) {
    const bool left = static_cast<std::size_t>(fluid.id[static_cast<std::size_t>(i)]) < upstream;
    for (const std::int32_t j : fluid_row(view, i, fluid.n)) {
      const bool other = static_cast<std::size_t>(fluid.id[static_cast<std::size_t>(j)]) < upstream;
      EXPECT_EQ(left, other) << "a fluid pair reaches through the plate at dx = " << dx;
    }
    for (const std::int32_t k : wall_row(view, i, walls)) {
      const Face& face =
          setup.solids.faces[static_cast<std::size_t>(walls.owner[static_cast<std::size_t>(k)])];
      if (face.barrier < 0 || face.normal.z > 0.5) continue;  // bed, crest
      EXPECT_EQ(left, face.normal.x < 0.0) << "a particle sees the far side's wall points";
    }
  }
}

TEST_P(ThinPlate, EverySideFeelsACompleteWall) {
  // beside the middle of the plate, fluid and wall together fill the kernel
  const double dx = GetParam(), thickness = 0.015, h = 1.33 * dx;
  Scene scene;
  Barrier barrier;
  barrier.foot_x = 0.5;
  barrier.height = 0.3;
  barrier.thickness = thickness;
  barrier.stem_lean = -scene.slope;
  scene.barriers = {barrier};
  Numerics numerics;
  numerics.spacing = dx;
  const FlowSetup setup = channel_setup(scene, numerics, 1);
  Fluid fluid;
  fluid.assign(lattice_block(0.5 - 8 * dx, 0, 8 * dx, 0.3, dx, 1000));
  const WallPoints walls = lay_out_walls(setup.solids, dx, 2.0 * h);
  NeighborRows rows(setup.solids, walls, 2.0 * h, 0.25 * h, dx, 0.0);
  rows.build(fluid, 1);
  const Kernel kernel = make_kernel(h, dx);
  const PickedRows picked(fluid, walls, rows, 2.25 * h);
  const RowView& view = picked.view;
  int tested = 0;
  for (int i = 0; i < fluid.n; ++i) {
    const auto a = static_cast<std::size_t>(i);
    if (fluid.x[a] < 0.5 - dx || std::abs(fluid.z[a] - 0.15) > 0.02) continue;
    double unity = kernel.alpha * dx * dx;
    const auto add = [&](double x, double z, double volume) {
      const double r = std::hypot(fluid.x[a] - x, fluid.z[a] - z);
      unity += kernel.alpha * kernel_shape(r / h) * volume;
    };
    for (const std::int32_t j : fluid_row(view, i, fluid.n)) {
      add(fluid.x[static_cast<std::size_t>(j)], fluid.z[static_cast<std::size_t>(j)], dx * dx);
    }
    for (const std::int32_t index : wall_row(view, i, walls)) {
      const auto k = static_cast<std::size_t>(index);
      add(walls.x[k], walls.z[k], walls.volume[k]);
    }
    EXPECT_NEAR(unity, 1.0, 0.03);  // lattice quadrature of W at h/dx = 1.33 is 1.009
    ++tested;
  }
  EXPECT_GT(tested, 0);
}

INSTANTIATE_TEST_SUITE_P(Spacings, ThinPlate, ::testing::Values(0.020, 0.010, 0.005, 0.0025));

}  // namespace
}  // namespace parapet::solver
