/// Particle frames for ParaView: one VTK XML PolyData file per frame and a collection with times.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "parapet/solver/gauge_settings.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::reports {

/// Writes frames into a folder as they come. Open `<case>.pvd` in ParaView.
///
/// Each `<case>_000012.vtp` holds the fluid particles as points with a vertex cell each, in channel
/// axes with z upwards (the second coordinate), and the point arrays velocity_m_s (3 components),
/// pressure_pa, density_kg_m3, viscosity_pa_s and id. Written once: `<case>_walls.vtp`, the wall
/// points; `<case>_outlines.vtp`, bed, barriers and other solids as lines, filled by polygons,
/// with the cell array `barrier`, the barrier's number from 1 upstream or 0; `<case>_gauges.vtp`,
/// where the metrics look, lines with the cell array `gauge`: 0 the line of a barrier, 1 the two
/// ends of the base of the front's speed, 2 of the window of kinetic energy, 3 of the window of an
/// open channel's depth. Every file is complete before it gets its name, and the collection lists
/// only files that exist, so a run killed at any time leaves a folder that opens.
class FrameWriter {
 public:
  /// Creates the folder. Frames of an earlier run with the same case name are written over.
  /// @throws std::invalid_argument when the case name is empty.
  /// @throws FileError when the folder cannot be made.
  FrameWriter(std::filesystem::path directory, const std::string& case_name, solver::Scene scene,
              const solver::GaugeSettings& settings);

  /// Writes one frame and brings the collection up to date. Usable as Callbacks::on_frame. A frame
  /// that is not later than the one before is passed over.
  /// @throws std::invalid_argument when the frame's arrays [n_fluid] differ in length.
  /// @throws FileError naming the file that cannot be written.
  void add(const solver::Frame& frame);

  /// Number of frames written.
  std::size_t count() const { return times_.size(); }

  /// The file to open in ParaView.
  const std::filesystem::path& collection() const { return collection_; }

 private:
  std::filesystem::path directory_;
  std::string stem_;  ///< case name with only letters, digits, '-', '_' and '.'
  solver::Scene scene_;
  solver::GaugeSettings gauges_;
  std::filesystem::path collection_;
  std::vector<double> times_;  ///< of the frames written [s]
};

}  // namespace parapet::reports
