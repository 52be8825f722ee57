#include "parapet/records/flow_recording.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "parapet/designs/case_spec.hpp"

namespace parapet::records {
namespace {

designs::CaseSpec small_case() {
  return designs::parse_case(designs::Json::parse(R"({
    "format": "parapet-case/1", "name": "<b>hostile\" & name", "channel": {"length_m": 2.0},
    "barriers": [{"foot_x_m": 1.1, "height_m": 0.1, "deflector": {"angle_deg": 45, "length_m": 0.065}}],
    "numerics": {"spacing_m": 0.02}})"),
                             "test");
}

/// Particles that fly, jitter, come to rest and leave.
struct Cloud {
  std::vector<double> x, z, u, w, density, pressure, viscosity;
  std::vector<std::int32_t> id;

  solver::Frame frame(double time) const {
    return {.time = time,
            .last = false,
            .x = x,
            .z = z,
            .u = u,
            .w = w,
            .density = density,
            .pressure = pressure,
            .viscosity = viscosity,
            .id = id,
            .wall_x = {},
            .wall_z = {},
            .mass = {}};
  }
};

Cloud cloud(int n, double time, std::mt19937& random) {
  std::uniform_real_distribution<double> noise(-1.0, 1.0);
  Cloud c;
  for (int k = n - 1; k >= 0; --k) {         // solvers sort them anew
    if (k % 7 == 3 && time > 0.3) continue;  // left
    const bool rests = k % 5 == 0;
    c.id.push_back(k);
    c.x.push_back(0.01 * k + (rests ? 0.0 : 1.5 * time + 1e-3 * noise(random)));
    c.z.push_back(0.05 + (rests ? 0.0 : 0.5 * std::sin(3.0 * time + k)) * 0.1);
    c.u.push_back(rests ? 1e-4 : 1.5 + 0.1 * noise(random));
    c.w.push_back(0.0);
    c.density.push_back(1135.0);
    c.pressure.push_back(300.0 * noise(random));
    c.viscosity.push_back(rests ? 900.0 : 4.0 + noise(random));
  }
  return c;
}

TEST(FlowRecording, GivesEveryNumberBackWithinHalfACount) {
  const designs::CaseSpec spec = small_case();
  RecordingWriter writer(spec, spec.name);
  std::mt19937 random(1);
  std::vector<Cloud> clouds;
  std::vector<double> times;
  for (int k = 0; k < 37; ++k) {  // two whole chunks and a part of one
    times.push_back(0.02 * k);
    clouds.push_back(cloud(120, times.back(), random));
    writer.add(clouds.back().frame(times.back()));
  }
  writer.add(clouds.back().frame(times.back()));  // the last state once more: passed over
  const std::string bytes = writer.finish();
  const FlowRecording recording = read_recording(bytes);
  const RecordingSteps steps = recording_steps(spec.scene, spec.numerics.spacing);
  EXPECT_EQ(recording.header.at("name"), spec.name);
  EXPECT_EQ(recording.header.at("times_s").get<std::vector<double>>(), times);
  ASSERT_EQ(recording.frames.size(), clouds.size());
  const double half = 0.5 * (1.0 + 1e-9);
  for (std::size_t f = 0; f < clouds.size(); ++f) {
    const Cloud& c = clouds[f];
    const RecordedFrame& r = recording.frames[f];
    EXPECT_EQ(r.time, times[f]);
    ASSERT_EQ(r.id.size(), c.id.size()) << f;
    for (std::size_t k = 0; k < c.id.size(); ++k) {
      const std::size_t j = c.id.size() - 1 - k;  // read back in the order of the ids
      ASSERT_EQ(r.id[j], c.id[k]);
      EXPECT_NEAR(r.x[j], c.x[k], half * steps.length);
      EXPECT_NEAR(r.z[j], c.z[k], half * steps.length);
      EXPECT_NEAR(r.speed[j], std::hypot(c.u[k], c.w[k]), half * steps.speed);
      EXPECT_NEAR(r.pressure[j], c.pressure[k], half * steps.pressure);
      EXPECT_NEAR(std::log2(r.viscosity[j] / c.viscosity[k]), 0.0, 0.0626);  // an eighth
      EXPECT_EQ(r.at_rest[j] != 0, std::abs(c.u[k]) < steps.rest_speed);
    }
  }
  EXPECT_LT(bytes.size(), 37U * 120U * 6U);  // 11 bytes a particle before compression
}

TEST(FlowRecording, KnowsTheSceneThatAPlayerDraws) {
  const designs::CaseSpec spec = small_case();
  RecordingWriter writer(spec, spec.name);
  const designs::Json header = recording_header(writer.finish());
  const designs::Json& barrier = header.at("scene").at("barriers").at(0);
  EXPECT_EQ(barrier.at("foot_x_m"), 1.1);
  EXPECT_NEAR(barrier.at("deflector").at("angle_deg").get<double>(), 45.0, 1e-12);
  EXPECT_EQ(barrier.at("outline").size(), 6U);  // with a deflector
  EXPECT_EQ(header.at("particles"), 0);
}

TEST(FlowRecording, IntervalFollowsTheSizeOfTheEvent) {
  solver::Scene scene;  // 0.2 m high
  EXPECT_DOUBLE_EQ(recording_interval(scene, 6.0), 0.02);
  EXPECT_DOUBLE_EQ(recording_interval(scene, 60.0), 0.2);  // 300 frames
  scene.reservoir_height *= 1600.0;                        // times are 40 times longer
  EXPECT_DOUBLE_EQ(recording_interval(scene, 240.0), 1.0);
}

TEST(FlowRecording, RefusesWhatIsNotOne) {
  const designs::CaseSpec spec = small_case();
  RecordingWriter writer(spec, spec.name);
  std::mt19937 random(2);
  for (int k = 0; k < 20; ++k) writer.add(cloud(50, 0.02 * k, random).frame(0.02 * k));
  const std::string bytes = writer.finish();
  EXPECT_NO_THROW(read_recording(bytes));
  EXPECT_THROW(read_recording(""), std::runtime_error);
  EXPECT_THROW(read_recording("PARAPET\n\xff\xff\xff\xff"), std::runtime_error);
  EXPECT_THROW(read_recording(bytes + "x"), std::runtime_error);
  for (std::size_t cut = 0; cut < bytes.size(); cut += 97) {
    EXPECT_THROW(read_recording(bytes.substr(0, cut)), std::runtime_error) << cut;
  }
  std::string other = bytes;
  other[bytes.size() - 40] = static_cast<char>(other[bytes.size() - 40] ^ 0x20);
  EXPECT_THROW(read_recording(other), std::runtime_error);  // zlib's own checksum
  Cloud stranger = cloud(50, 0.0, random);
  stranger.id.front() = 50;
  RecordingWriter again(spec, spec.name);
  again.add(cloud(50, 0.0, random).frame(0.0));
  EXPECT_THROW(again.add(stranger.frame(0.1)), std::invalid_argument);
}

}  // namespace
}  // namespace parapet::records
