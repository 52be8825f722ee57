/// One panel of a flow picture: where channel coordinates lie on the page, and the scene in it.
#pragma once

#include "parapet/reports/canvas.hpp"
#include "parapet/reports/flow_picture.hpp"
#include "parapet/solver/scene.hpp"

namespace parapet::reports {

/// A rectangle in turned coordinates: x to the right, y up [m].
struct Region {
  double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;

  double width() const { return right - left; }
  double height() const { return top - bottom; }
};

/// Turns channel axes into the picture's: world axes have their origin below the first barrier's
/// foot in height (below the back wall without a barrier) and at the back wall in distance.
class Turn {
 public:
  Turn(const solver::Scene& scene, PictureAxes axes);
  solver::Vec2 operator()(solver::Vec2 channel) const;

 private:
  double cosine_ = 1.0, sine_ = 0.0, datum_ = 0.0;
};

/// The stretch of bed shown [m].
struct BedRange {
  double from = 0.0, to = 0.0;
};

/// As asked, or from just behind the back wall to what the flow and the barriers reach.
/// @throws std::invalid_argument when the range asked for is empty.
BedRange bed_range(const solver::Scene& scene, const std::vector<FlowSnapshot>& snapshots,
                   const FlowPictureOptions& options);

/// What must be seen of the scene and of all snapshots, with some ground below the bed.
Region visible_region(const solver::Scene& scene, const Turn& turn, const BedRange& bed,
                      const std::vector<FlowSnapshot>& snapshots);

/// A panel: a region on a box of the page, both of the same aspect ratio.
struct FlowView {
  const solver::Scene* scene;
  Turn turn;
  BedRange bed;
  Region region;
  PixelBox box;

  double scale() const { return box.width / region.width(); }  ///< [px/m]
  Pixel page(solver::Vec2 turned) const;
  Pixel at(solver::Vec2 channel) const { return page(turn(channel)); }
};

/// Ground, back wall, solids and barriers, then the particles, clipped to the panel.
/// @param bed_labels marks distances along the bed in the ground
void draw_scene(Canvas& canvas, const FlowView& view, double font, bool bed_labels);
void draw_particles(Canvas& canvas, const FlowView& view, const FlowSnapshot& snapshot,
                    double spacing, double speed_limit);

}  // namespace parapet::reports
