#include "parapet/reports/vtk_frames.hpp"

#include <array>
#include <cstring>
#include <regex>
#include <stdexcept>
#include <vector>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/deflate.hpp"
#include "scratch_folder.hpp"

namespace parapet::reports {
namespace {

/// Three particles and two wall points with numbers that no two arrays share.
struct SmallFlow {
  std::vector<double> x{0.1, 0.2, 1.0 / 3.0}, z{0.01, 0.02, 0.03};
  std::vector<double> u{1.5, -2.5, 1e-7}, w{0.25, 0.5, -0.75};
  std::vector<double> density{1135.0, 1136.5, 1134.25}, pressure{0.0, 1837.5, -12.0};
  std::vector<double> viscosity{906.9, 4.5, 0.125};
  std::vector<std::int32_t> id{7, 0, 70000};
  std::vector<double> wall_x{0.0, 3.0}, wall_z{-0.0025, -0.0075};

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
            .wall_x = wall_x,
            .wall_z = wall_z,
            .mass = {}};
  }
};

std::vector<unsigned char> decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  unsigned group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) throw std::runtime_error("not base64");
    group = (group << 6) | static_cast<unsigned>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<unsigned char>((group >> bits) & 0xFFU));
  }
  return bytes;
}

/// The numbers of an inline compressed array; the byte counts in front must be right.
template <typename T>
std::vector<T> array(const std::string& xml, const std::string& type, const std::string& name,
                     int components) {
  const std::string head = "<DataArray type=\"" + type + "\" Name=\"" + name +
                           "\" NumberOfComponents=\"" + std::to_string(components) +
                           "\" format=\"binary\">";
  const std::size_t start = xml.find(head);
  if (start == std::string::npos) throw std::runtime_error("no array " + name);
  const std::size_t end = xml.find("</DataArray>", start);
  const std::string text = xml.substr(start + head.size(), end - start - head.size());
  // Four 64-bit numbers take 44 digits of base64, three (of an empty array) take 32.
  std::array<std::uint64_t, 4> counts{};
  const std::size_t header = text.size() > 32 ? 44 : 32;
  const std::vector<unsigned char> front = decoded(text.substr(0, header));
  std::memcpy(counts.data(), front.data(), front.size());
  EXPECT_EQ(counts[2], 0U) << name;
  if (counts[0] == 0) return {};
  EXPECT_EQ(counts[0], 1U) << name;
  const std::vector<unsigned char> block = decoded(text.substr(header));
  EXPECT_EQ(block.size(), counts[3]) << name;
  const std::vector<std::uint8_t> bytes = records::inflated(
      std::string_view(reinterpret_cast<const char*>(block.data()), block.size()), counts[1]);
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

std::vector<float> floats(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

/// Every tag is closed in the right order.
bool well_formed(const std::string& xml) {
  const std::regex tag("<(/?)([A-Za-z]+)([^<>]*?)(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator it(xml.begin(), xml.end(), tag), end; it != end; ++it) {
    const std::string name = (*it)[2];
    if ((*it)[4].length() > 0) continue;
    if ((*it)[1].length() == 0) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty() && xml.starts_with("<?xml version=\"1.0\"?>\n<VTKFile ");
}

/// A bare barrier at 1 m and one with a deflector at 2 m, of 0.1 m, upright on a level bed.
solver::Scene barriers() {
  solver::Scene scene;
  scene.slope = 0.0;
  scene.barriers = {
      {.foot_x = 1.0, .height = 0.1, .thickness = 0.02, .deflector = {}},
      {.foot_x = 2.0, .height = 0.1, .thickness = 0.02, .deflector = solver::Deflector{}}};
  return scene;
}

using FrameWriterTest = ScratchFolder;

TEST_F(FrameWriterTest, NumbersSurviveTheRoundTripInSinglePrecision) {
  const SmallFlow flow;
  FrameWriter writer(folder_, "dam", barriers(), {});
  writer.add(flow.frame(0.25));
  const std::string xml = content(folder_ / "dam_000000.vtp");
  EXPECT_TRUE(well_formed(xml));
  EXPECT_NE(xml.find("byte_order=\"LittleEndian\" header_type=\"UInt64\""), std::string::npos);
  EXPECT_NE(xml.find("NumberOfPoints=\"3\" NumberOfVerts=\"3\""), std::string::npos);
  const auto position = array<float>(xml, "Float32", "position_m", 3);
  const auto velocity = array<float>(xml, "Float32", "velocity_m_s", 3);
  ASSERT_EQ(position.size(), 9U);
  ASSERT_EQ(velocity.size(), 9U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(position[3 * k], static_cast<float>(flow.x[k]));
    EXPECT_EQ(position[3 * k + 1], static_cast<float>(flow.z[k]));
    EXPECT_EQ(position[3 * k + 2], 0.0F);
    EXPECT_EQ(velocity[3 * k], static_cast<float>(flow.u[k]));
    EXPECT_EQ(velocity[3 * k + 1], static_cast<float>(flow.w[k]));
  }
  EXPECT_EQ(array<float>(xml, "Float32", "pressure_pa", 1), floats(flow.pressure));
  EXPECT_EQ(array<float>(xml, "Float32", "density_kg_m3", 1), floats(flow.density));
  EXPECT_EQ(array<float>(xml, "Float32", "viscosity_pa_s", 1), floats(flow.viscosity));
  EXPECT_EQ(array<std::int32_t>(xml, "Int32", "id", 1), flow.id);
}

TEST_F(FrameWriterTest, EveryPointIsAVertexCell) {
  FrameWriter writer(folder_, "dam", barriers(), {});
  writer.add(SmallFlow().frame(0.0));
  const std::string xml = content(folder_ / "dam_000000.vtp");
  EXPECT_EQ(array<std::int32_t>(xml, "Int32", "connectivity", 1),
            (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(array<std::int32_t>(xml, "Int32", "offsets", 1), (std::vector<std::int32_t>{1, 2, 3}));
}

TEST_F(FrameWriterTest, WallsAreWrittenOnce) {
  FrameWriter writer(folder_, "dam", barriers(), {});
  writer.add(SmallFlow().frame(0.0));
  const std::string xml = content(folder_ / "dam_walls.vtp");
  EXPECT_TRUE(well_formed(xml));
  const auto position = array<float>(xml, "Float32", "position_m", 3);
  EXPECT_EQ(position, (std::vector<float>{0.0F, -0.0025F, 0.0F, 3.0F, -0.0075F, 0.0F}));
  std::filesystem::remove(folder_ / "dam_walls.vtp");
  writer.add(SmallFlow().frame(0.1));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "dam_walls.vtp"));
}

TEST_F(FrameWriterTest, BodiesAreClosedLinesFilledByConvexPolygons) {
  FrameWriter writer(folder_, "dam", barriers(), {});
  writer.add(SmallFlow().frame(0.0));
  const std::string xml = content(folder_ / "dam_outlines.vtp");
  EXPECT_TRUE(well_formed(xml));
  // Points: three of the bed, five and seven of the closed outlines, four of each of three
  // fillings.
  EXPECT_NE(xml.find("NumberOfPoints=\"27\" NumberOfVerts=\"0\" NumberOfLines=\"3\" "
                     "NumberOfStrips=\"0\" NumberOfPolys=\"3\""),
            std::string::npos)
      << xml.substr(0, 400);
  EXPECT_EQ(array<std::int32_t>(xml, "Int32", "barrier", 1),
            (std::vector<std::int32_t>{0, 1, 2, 1, 2, 2}));
  const auto position = array<float>(xml, "Float32", "position_m", 3);
  ASSERT_EQ(position.size(), 81U);
  EXPECT_EQ(std::vector<float>(position.begin() + 9, position.begin() + 15),
            (std::vector<float>{1.0F, 0.0F, 0.0F, 1.0F, 0.1F, 0.0F}));
  const std::string collection = content(writer.collection());
  EXPECT_NE(collection.find("part=\"2\" name=\"outlines\" file=\"dam_outlines.vtp\""),
            std::string::npos);
  EXPECT_NE(collection.find("part=\"3\" name=\"gauges\" file=\"dam_gauges.vtp\""),
            std::string::npos);
}

TEST_F(FrameWriterTest, GaugesStandWhereTheMetricsLook) {
  const auto places = [&](const solver::Scene& scene) {
    FrameWriter writer(folder_, "dam", scene, {});
    writer.add(SmallFlow().frame(0.0));
    const std::string xml = content(folder_ / "dam_gauges.vtp");
    EXPECT_TRUE(well_formed(xml));
    const auto position = array<float>(xml, "Float32", "position_m", 3);
    std::vector<std::pair<std::int32_t, float>> feet;
    for (const std::int32_t gauge : array<std::int32_t>(xml, "Int32", "gauge", 1)) {
      feet.emplace_back(gauge, position[6 * feet.size()]);
    }
    return feet;
  };
  using Feet = std::vector<std::pair<std::int32_t, float>>;
  // H0 = 0.2 m: the front's speed from 0.25 to 0.15 m before the foot, energy 50 mm either side.
  EXPECT_EQ(places(barriers()),
            (Feet{{0, 1.0F}, {0, 2.0F}, {1, 0.75F}, {1, 0.85F}, {2, 0.95F}, {2, 1.05F}}));
  solver::Scene open;
  open.monitor_x = 1.0;
  EXPECT_EQ(places(open),
            (Feet{{1, 0.95F}, {1, 1.05F}, {2, 0.95F}, {2, 1.05F}, {3, 0.96F}, {3, 1.0F}}));
}

TEST_F(FrameWriterTest, TheCollectionIsCompleteAfterEachFrame) {
  FrameWriter writer(folder_, "dam", barriers(), {});
  const std::regex entry("timestep=\"([^\"]+)\" part=\"0\" name=\"debris\" file=\"([^\"]+)\"");
  const std::vector<double> times{0.0, 0.05, 0.1};
  for (std::size_t n = 0; n < times.size(); ++n) {
    writer.add(SmallFlow().frame(times[n]));
    const std::string xml = content(writer.collection());
    EXPECT_TRUE(well_formed(xml));
    std::size_t listed = 0;
    for (std::sregex_iterator it(xml.begin(), xml.end(), entry), end; it != end; ++it, ++listed) {
      EXPECT_EQ(std::stod((*it)[1]), times[listed]);
      EXPECT_TRUE(std::filesystem::exists(folder_ / (*it)[2].str()));
    }
    EXPECT_EQ(listed, n + 1);
  }
  EXPECT_EQ(writer.count(), 3U);
  EXPECT_EQ(files(), 7U) << "three frames, walls, outlines, gauges and the collection; nothing "
                            "left aside";
}

TEST_F(FrameWriterTest, AFrameWithoutParticlesIsStillAFile) {
  FrameWriter writer(folder_, "dam", barriers(), {});
  writer.add(solver::Frame{});
  const std::string xml = content(folder_ / "dam_000000.vtp");
  EXPECT_TRUE(well_formed(xml));
  EXPECT_TRUE(array<float>(xml, "Float32", "position_m", 3).empty());
}

TEST_F(FrameWriterTest, CaseNamesCannotEscapeTheFolder) {
  FrameWriter writer(folder_, "a/b \"c\" & d", barriers(), {});
  writer.add(SmallFlow().frame(0.0));
  // The hash keeps it apart from other names whose characters were replaced.
  EXPECT_EQ(writer.collection().parent_path(), folder_);
  const std::string file = writer.collection().filename().string();
  EXPECT_TRUE(file.starts_with("a_b__c____d-")) << file;
  EXPECT_EQ(file.size(), std::string("a_b__c____d-01234567.pvd").size()) << file;
  EXPECT_TRUE(well_formed(content(writer.collection())));
}

TEST_F(FrameWriterTest, RefusesArraysOfUnequalLength) {
  SmallFlow flow;
  flow.pressure.pop_back();
  FrameWriter writer(folder_, "dam", barriers(), {});
  EXPECT_THROW(writer.add(flow.frame(0.0)), std::invalid_argument);
  EXPECT_EQ(files(), 0U);
}

TEST_F(FrameWriterTest, RefusesAFileInPlaceOfTheFolder) {
  write(folder_ / "taken", "text");
  EXPECT_THROW(FrameWriter(folder_ / "taken", "dam", {}, {}), records::FileError);
  EXPECT_THROW(FrameWriter(folder_, "", {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace parapet::reports
