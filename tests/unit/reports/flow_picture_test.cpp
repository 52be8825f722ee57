#include "parapet/reports/flow_picture.hpp"

#include <cmath>
#include <complex>
#include <stdexcept>

#include "parapet/records/atomic_file.hpp"
#include "picture_pixels.hpp"
#include "scratch_folder.hpp"

namespace parapet::reports {
namespace {

constexpr std::uint32_t slowest = 0x440154;  // the colour scale's two ends
constexpr std::uint32_t fastest = 0xFDE725;
constexpr std::uint32_t middling = 0x238A8D;  // its tenth of twenty entries
constexpr std::uint32_t barrier_color = 0x5C5E66;
constexpr double spacing = 0.01;
constexpr double limit = 2.0;

void add_block(FlowSnapshot& snapshot, double x, double z, double speed) {
  for (int i = -2; i <= 2; ++i) {
    for (int k = -2; k <= 2; ++k) {
      snapshot.x.push_back(x + i * spacing);
      snapshot.z.push_back(z + k * spacing);
      snapshot.speed.push_back(speed);
    }
  }
}

/// Blocks of a slow, a fast and a middling speed at (0.2, 0.1), (0.8, 0.1) and (0.5, 0.2).
FlowSnapshot three_blocks(double time) {
  FlowSnapshot snapshot;
  snapshot.time = time;
  add_block(snapshot, 0.2, 0.1, 0.0);
  add_block(snapshot, 0.8, 0.1, limit);
  add_block(snapshot, 0.5, 0.2, limit * 9.0 / 19.0);
  return snapshot;
}

FlowPictureOptions options(PictureAxes axes) {
  FlowPictureOptions chosen;
  chosen.width_px = 1000;
  chosen.speed_limit = limit;
  chosen.x_to = 1.1;
  chosen.axes = axes;
  return chosen;
}

/// Right end of the panels: the colour bar, which has all the colours, lies beyond.
constexpr int panel_end = 900;

using Arrow = std::complex<double>;

Arrow arrow(const PicturePixels::Patch& from, const PicturePixels::Patch& to) {
  return {to.x - from.x, from.y - to.y};  // y upwards
}

using FlowPicture = ScratchFolder;

TEST_F(FlowPicture, HasTheAskedWidthAndManyColours) {
  const auto file = folder_ / "flow.png";
  draw_flow(file, solver::Scene{}, spacing, {three_blocks(0.5)}, options(PictureAxes::world));
  const PicturePixels picture(file);
  EXPECT_EQ(picture.width(), 1000);
  EXPECT_GT(picture.height(), 200);
  // The colour bar alone has 200 shades.
  EXPECT_GT(picture.colors(), 200U);
}

/// Direction and distance on the page follow from the coordinates: a similarity, turned by the
/// bed's slope in world axes and not turned in channel axes.
TEST_F(FlowPicture, ParticlesLieWhereTheyShould) {
  for (const PictureAxes axes : {PictureAxes::world, PictureAxes::channel}) {
    const solver::Scene scene;
    const auto file = folder_ / "flow.png";
    draw_flow(file, scene, spacing, {three_blocks(0.5)}, options(axes));
    const PicturePixels picture(file);
    const auto slow = picture.patch(slowest, 0, panel_end);
    const auto fast = picture.patch(fastest, 0, panel_end);
    const auto middle = picture.patch(middling, 0, panel_end);
    ASSERT_GT(slow.count, 100);
    ASSERT_GT(fast.count, 100);
    ASSERT_GT(middle.count, 100);
    const Arrow along = arrow(slow, fast);
    const double turn = axes == PictureAxes::world ? -scene.slope : 0.0;
    // Half a pixel in some 400: 0.002 rad.
    EXPECT_NEAR(std::arg(along), turn, 0.003);
    // The third block: 0.3 + 0.1 i of 0.6 along the bed.
    EXPECT_NEAR(std::abs(arrow(slow, middle) / along - Arrow(0.5, 1.0 / 6.0)), 0.0, 0.005);
  }
}

/// Discs of about dx on a lattice of dx fill the block: 25 particles cover 25 dx^2.
TEST_F(FlowPicture, DiscsHaveTheSizeOfTheSpacing) {
  const auto file = folder_ / "flow.png";
  draw_flow(file, solver::Scene{}, spacing, {three_blocks(0.5)}, options(PictureAxes::channel));
  const PicturePixels picture(file);
  const auto slow = picture.patch(slowest, 0, panel_end);
  const double scale = std::abs(arrow(slow, picture.patch(fastest, 0, panel_end))) / 0.6;
  const double block = 25.0 * spacing * spacing * scale * scale;
  EXPECT_GT(slow.count, 0.75 * block);  // edges are blended with the background
  EXPECT_LT(slow.count, 1.15 * block);
}

TEST_F(FlowPicture, BarriersAreDrawnInTheirSize) {
  solver::Scene scene;
  solver::Barrier barrier;
  barrier.height = 0.3;
  barrier.thickness = 0.03;
  scene.barriers.push_back(barrier);
  FlowPictureOptions chosen = options(PictureAxes::channel);
  chosen.x_to = 1.3;
  draw_flow(folder_ / "with.png", scene, spacing, {three_blocks(0.5)}, chosen);
  const PicturePixels picture(folder_ / "with.png");
  const double scale =
      std::abs(arrow(picture.patch(slowest, 0, panel_end), picture.patch(fastest, 0, panel_end))) /
      0.6;
  // Counted right of the middle, away from the back wall. The outline's pen covers a pixel or two
  // of the 20 pixels of thickness.
  const auto seen = picture.patch(barrier_color, 500, panel_end);
  EXPECT_NEAR(seen.count / (scale * scale), 0.3 * 0.03, 0.25 * 0.3 * 0.03);
}

TEST_F(FlowPicture, EachSnapshotHasItsPanel) {
  FlowPictureOptions chosen = options(PictureAxes::world);
  chosen.columns = 2;
  draw_flow(folder_ / "two.png", solver::Scene{}, spacing, {three_blocks(0.5), three_blocks(1.0)},
            chosen);
  const PicturePixels picture(folder_ / "two.png");
  EXPECT_GT(picture.patch(fastest, 0, 470).count, 20);
  EXPECT_GT(picture.patch(fastest, 470, panel_end).count, 20);
}

TEST_F(FlowPicture, FasterThanTheLimitAndNotFiniteAreHarmless) {
  FlowSnapshot snapshot = three_blocks(0.5);
  snapshot.speed[0] = 100.0;
  snapshot.x[1] = std::nan("");
  draw_flow(folder_ / "flow.png", solver::Scene{}, spacing, {snapshot},
            options(PictureAxes::world));
  EXPECT_EQ(PicturePixels(folder_ / "flow.png").width(), 1000);
}

TEST_F(FlowPicture, WritesSvgByItsEnding) {
  draw_flow(folder_ / "flow.svg", solver::Scene{}, spacing, {three_blocks(0.5)},
            options(PictureAxes::world));
  const std::string text = content(folder_ / "flow.svg");
  EXPECT_TRUE(text.starts_with("<?xml"));
  EXPECT_NE(text.find("width=\"1000px\""), std::string::npos);
  EXPECT_NE(text.find("</svg>"), std::string::npos);
}

TEST_F(FlowPicture, RefusesWhatCannotBeDrawn) {
  const solver::Scene scene;
  const auto file = folder_ / "flow.png";
  EXPECT_THROW(draw_flow(file, scene, spacing, {}), std::invalid_argument);
  EXPECT_THROW(draw_flow(folder_ / "flow.jpg", scene, spacing, {three_blocks(0.0)}),
               std::invalid_argument);
  FlowSnapshot uneven = three_blocks(0.0);
  uneven.speed.pop_back();
  EXPECT_THROW(draw_flow(file, scene, spacing, {uneven}), std::invalid_argument);
  FlowPictureOptions empty;
  empty.x_from = 2.0;
  empty.x_to = 1.0;
  EXPECT_THROW(draw_flow(file, scene, spacing, {three_blocks(0.0)}, empty), std::invalid_argument);
  EXPECT_EQ(files(), 0U);
  EXPECT_THROW(draw_flow(folder_ / "none" / "flow.png", scene, spacing, {three_blocks(0.0)}),
               records::FileError);
}

TEST(TakeSnapshot, KeepsPlacesAndSpeeds) {
  const std::vector<double> x{0.1, 0.2}, z{0.3, 0.4}, u{3.0, 0.0}, w{-4.0, 0.5};
  solver::Frame frame;
  frame.time = 1.25;
  frame.x = x;
  frame.z = z;
  frame.u = u;
  frame.w = w;
  const FlowSnapshot snapshot = take_snapshot(frame);
  EXPECT_EQ(snapshot.time, 1.25);
  EXPECT_EQ(snapshot.x, x);
  EXPECT_EQ(snapshot.z, z);
  EXPECT_EQ(snapshot.speed, (std::vector<double>{5.0, 0.5}));
}

}  // namespace
}  // namespace parapet::reports
