/// Pictures of the flow: particles coloured by speed, bed and barriers, one panel per time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parapet/solver/simulation.hpp"

namespace parapet::reports {

/// What a picture needs of a frame, copied so that it outlives the callback.
struct FlowSnapshot {
  double time = 0.0;          ///< [s]
  std::vector<double> x, z;   ///< channel axes, [n_fluid] [m]
  std::vector<double> speed;  ///< [n_fluid] [m/s]
};

/// Copies what a picture needs out of a frame.
FlowSnapshot take_snapshot(const solver::Frame& frame);

/// How the scene is turned.
enum class PictureAxes {
  world,   ///< as seen in the field: gravity down, the bed falls to the right
  channel  ///< x along the bed, z normal to it
};

/// How the picture looks.
struct FlowPictureOptions {
  int width_px = 1600;           ///< of the whole figure; the height follows from the aspect
  int columns = 0;               ///< of panels; 0 chooses
  double speed_limit = 0.0;      ///< upper end of the colour bar [m/s]; 0 takes it from the data
  std::optional<double> x_from;  ///< along the bed [m]; default: just behind the back wall
  std::optional<double> x_to;    ///< along the bed [m]; default: what the flow reaches
  std::string title;             ///< names the design; empty for none
  PictureAxes axes = PictureAxes::world;
};

/// Draws a figure of one panel per snapshot. Particles are discs of the particle spacing in true
/// aspect ratio; lengths on both axes have the same scale.
/// @param path ends in .png or .svg, which decides the format.
/// @param spacing particle spacing dx [m]
/// @throws std::invalid_argument for no snapshots, arrays of unequal length, or another ending.
/// @throws FileError when the file cannot be written.
void draw_flow(const std::filesystem::path& path, const solver::Scene& scene, double spacing,
               const std::vector<FlowSnapshot>& snapshots, const FlowPictureOptions& options = {});

}  // namespace parapet::reports
