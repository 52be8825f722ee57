// The particle store: what is done to all quantities alike is done to every line of its table.
#include "parapet/flow/fluid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <set>
#include <string>

#include "parapet/flow/channel.hpp"
#include "parapet/flow/wall_layout.hpp"

namespace parapet::solver {
namespace {

using Values = std::vector<double>;

// Every particle has a value of its own in every quantity.
double value_of(std::size_t field, std::size_t particle) {
  return 1000.0 * static_cast<double>(field + 1) + static_cast<double>(particle);
}

Fluid numbered(std::size_t n) {
  Fluid fluid;
  fluid.assign(std::vector<InitialParticle>(n));
  std::size_t field = 0;
  fluid.for_each_field([&](const FieldInfo&, Values& array) {
    for (std::size_t i = 0; i < n; ++i) array[i] = value_of(field, i);
    ++field;
  });
  return fluid;
}

TEST(ParticleTable, NamesEveryQuantityOnce) {
  const Fluid fluid;
  std::set<std::string> names;
  std::set<const Values*> arrays;
  std::size_t count = 0;
  fluid.for_each_field([&](const FieldInfo& field, const Values& array) {
    names.insert(field.name);
    arrays.insert(&array);
    ++count;
  });
  EXPECT_EQ(names.size(), count);
  EXPECT_EQ(arrays.size(), count);
  for (const char* name : {"x", "pressure", "density_rate"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  // No array stands beside the table: there are the number of particles, the quantities, three
  // kinds of records, the ids, and what permute() keeps its copies in.
  EXPECT_EQ(sizeof(Fluid), sizeof(std::size_t) + (count + 3 + 1 + 2) * sizeof(Values));
}

TEST(ParticleTable, AssignSizesEveryArrayAndSetsTheGhost) {
  Fluid fluid = numbered(7);
  const std::vector<InitialParticle> two{{1.0, 2.0, 3.0, 4.0, 5.0, 6.0},
                                         {-1.0, -2.0, -3.0, -4.0, 7.0, 8.0}};
  fluid.assign(two);
  EXPECT_EQ(fluid.n, 2);
  fluid.for_each_field([&](const FieldInfo& field, const Values& array) {
    ASSERT_EQ(array.size(), 3u) << field.name;
    EXPECT_EQ(array[2], field.ghost) << field.name;
    if (field.lifetime == Lifetime::state) return;
    EXPECT_EQ(array[0], field.first) << field.name;
    EXPECT_EQ(array[1], field.first) << field.name;
  });
  for (int i = 0; i < 2; ++i) {
    const InitialParticle p = fluid.particle(i), &q = two[static_cast<std::size_t>(i)];
    // All its members are doubles. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
    EXPECT_EQ(std::memcmp(&p, &q, sizeof p), 0);
    EXPECT_EQ(fluid.id[static_cast<std::size_t>(i)], i);
  }
  EXPECT_EQ(fluid.x[2], far_away);
  EXPECT_EQ(fluid.density[2], 1.0) << "a volume must not divide by zero";
}

TEST(ParticleTable, SortingCarriesWhatSurvivesIt) {
  Fluid fluid = numbered(6);
  const std::vector<std::int32_t> order{4, 2, 0, 5, 1, 3};
  fluid.permute(order);
  std::size_t number = 0;
  fluid.for_each_field([&](const FieldInfo& field, const Values& array) {
    if (survives_sorting(field.lifetime)) {
      for (std::size_t k = 0; k < order.size(); ++k) {
        EXPECT_EQ(array[k], value_of(number, static_cast<std::size_t>(order[k]))) << field.name;
      }
    }
    EXPECT_EQ(array[order.size()], field.ghost) << field.name;
    ++number;
  });
  for (std::size_t k = 0; k < order.size(); ++k) EXPECT_EQ(fluid.id[k], order[k]);
}

TEST(ParticleTable, RemovalCarriesWhatSurvivesIt) {
  Fluid fluid = numbered(6);
  fluid.remove(std::vector<std::int32_t>{0, 3, 5});
  const std::vector<std::size_t> kept{1, 2, 4};
  ASSERT_EQ(fluid.n, 3);
  std::size_t number = 0;
  fluid.for_each_field([&](const FieldInfo& field, const Values& array) {
    ASSERT_EQ(array.size(), 4u) << field.name;
    EXPECT_EQ(array[3], field.ghost) << field.name;
    for (std::size_t k = 0; survives_removal(field.lifetime) && k < kept.size(); ++k) {
      EXPECT_EQ(array[k], value_of(number, kept[k])) << field.name;
    }
    ++number;
  });
  for (std::size_t k = 0; k < kept.size(); ++k) {
    EXPECT_EQ(fluid.id[k], static_cast<std::int32_t>(kept[k]));
  }
}

TEST(ParticleTable, PackingFillsEveryRecordOfTheRangeWithItsFields) {
  Fluid fluid = numbered(5);
  fluid.pack(1, 4);
#define PARAPET_CHECK(name, Type, a, b, c, d)                    \
  ASSERT_EQ(fluid.name.size(), 6u) << #name;                     \
  for (std::size_t i = 1; i < 4; ++i) {                          \
    EXPECT_EQ(fluid.name[i].a, fluid.a[i]);                      \
    EXPECT_EQ(fluid.name[i].b, fluid.b[i]);                      \
    EXPECT_EQ(fluid.name[i].c, fluid.c[i]);                      \
    EXPECT_EQ(fluid.name[i].d, fluid.d[i]);                      \
  }                                                              \
  EXPECT_NE(fluid.name[0].a, fluid.a[0]) << "outside the range"; \
  EXPECT_NE(fluid.name[4].a, fluid.a[4]) << "outside the range"; \
  EXPECT_EQ(fluid.name[5].a, fluid.a[5]) << "the ghost is always packed";
  PARAPET_PARTICLE_RECORDS(PARAPET_CHECK)
#undef PARAPET_CHECK
}

TEST(ParticleTable, ViewsPointAtTheArrays) {
  Fluid fluid = numbered(3);
  const FluidView view = fluid.view();
  const ShiftedRates rates = fluid.rates();
  EXPECT_EQ(view.n, 3);
#define PARAPET_CHECK(name, ...) EXPECT_EQ(view.name, fluid.name.data()) << #name;
  PARAPET_STATE_FIELDS(PARAPET_CHECK)
  PARAPET_DERIVED_FIELDS(PARAPET_CHECK)
  PARAPET_PARTICLE_RECORDS(PARAPET_CHECK)
#undef PARAPET_CHECK
#define PARAPET_CHECK(name, ...) EXPECT_EQ(rates.name, fluid.name.data()) << #name;
  PARAPET_RATE_FIELDS(PARAPET_CHECK)
#undef PARAPET_CHECK
}

TEST(ParticleTable, EveryGradientSumHasRoomOfItsOwn) {
  constexpr int n = 5;
  const GradientSumArrays sums(n);
  int arrays = 0;
#define PARAPET_FILL(name) std::fill_n(sums.view.name, n, arrays++);
  PARAPET_GRADIENT_SUMS(PARAPET_FILL)
#undef PARAPET_FILL
  EXPECT_EQ(arrays, 18);
  int array = 0;
#define PARAPET_CHECK(name)                                                 \
  for (int i = 0; i < n; ++i) EXPECT_EQ(sums.view.name[i], array) << #name; \
  ++array;
  PARAPET_GRADIENT_SUMS(PARAPET_CHECK)
#undef PARAPET_CHECK
}

// The lifetimes of the table are true: nothing is read that a sorting would have lost. Between its
// steps a flow whose quantities of the moment are spoilt computes the same bits as one left alone.
void expect_lifetimes_hold(Integrator integrator) {
  Scene scene;
  scene.domain_length = 0.38;  // so that some particles leave
  scene.material.yield_stress = 0.0;
  scene.material.consistency = scene.material.flow_index = 1.0;  // the explicit steps stay long
  Barrier barrier;
  barrier.foot_x = 0.34;
  barrier.height = 0.02;
  scene.barriers = {barrier};
  Numerics numerics;
  numerics.spacing = 0.02;
  numerics.integrator = integrator;
  Flow alone(channel_setup(scene, numerics, 1)), spoilt(channel_setup(scene, numerics, 1));
  while (alone.time() < 0.25) {
    ASSERT_FALSE(alone.step(0.1));
    spoilt.fluid().for_each_field([](const FieldInfo& field, Values& array) {
      if (survives_sorting(field.lifetime)) return;
      for (std::size_t i = 0; i + 1 < array.size(); ++i) {
        array[i] = std::numeric_limits<double>::quiet_NaN();
      }
    });
    ASSERT_FALSE(spoilt.step(0.1));
  }
  EXPECT_GT(alone.statistics().neighbor_builds, 5);
  EXPECT_GT(alone.departures().size(), 0u);
  ASSERT_EQ(alone.time(), spoilt.time());
  const Fluid &a = alone.fluid(), &b = spoilt.fluid();
  ASSERT_EQ(a.n, b.n);
  std::vector<Values> expected;
  a.for_each_field([&](const FieldInfo&, const Values& array) { expected.push_back(array); });
  std::size_t number = 0;
  b.for_each_field([&](const FieldInfo& field, const Values& array) {
    if (survives_removal(field.lifetime)) {
      EXPECT_EQ(array, expected[number]) << field.name;
    }
    ++number;
  });
}

TEST(ParticleTable, LifetimesHoldWithImplicitViscosity) {
  expect_lifetimes_hold(Integrator::implicit_viscosity);
}

TEST(ParticleTable, LifetimesHoldWithRungeKutta) {
  expect_lifetimes_hold(Integrator::rk4_explicit);
}

TEST(WallTable, EveryPointHasItsFieldsRecordsAndAGhost) {
  std::vector<WallPoint> points(3);
  double next = 1.0;
  for (WallPoint& point : points) {
#define PARAPET_NUMBER(name, ...) point.name = next++;
    PARAPET_WALL_FIELDS(PARAPET_NUMBER)
#undef PARAPET_NUMBER
  }
  WallPoints walls(points, {4, 5, 6});
  ASSERT_EQ(walls.size(), 3u);
  const WallView view = walls.view();
  EXPECT_EQ(view.n, 3);
  for (std::size_t k = 0; k < 3; ++k) {
#define PARAPET_CHECK(name, ...) EXPECT_EQ(view.name[k], points[k].name) << #name;
    PARAPET_WALL_FIELDS(PARAPET_CHECK)
#undef PARAPET_CHECK
  }
#define PARAPET_CHECK(name, ghost)           \
  ASSERT_EQ(walls.name.size(), 4u) << #name; \
  EXPECT_EQ(view.name[3], ghost) << #name;
  PARAPET_WALL_FIELDS(PARAPET_CHECK)
#undef PARAPET_CHECK
  for (std::size_t k = 0; k <= 3; ++k) {
#define PARAPET_CHECK(name, Type, a, b, c, d)     \
  EXPECT_EQ(view.name[k].a, walls.a[k]) << #name; \
  EXPECT_EQ(view.name[k].b, walls.b[k]) << #name; \
  EXPECT_EQ(view.name[k].c, walls.c[k]) << #name; \
  EXPECT_EQ(view.name[k].d, walls.d[k]) << #name;
    PARAPET_WALL_RECORDS(PARAPET_CHECK)
#undef PARAPET_CHECK
    EXPECT_EQ(view.pressure[k], 0.0);
  }
}

}  // namespace
}  // namespace parapet::solver
