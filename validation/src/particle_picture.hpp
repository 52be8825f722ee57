// Pictures of flows that are no channels: particles coloured by any quantity, walls as lines.
#pragma once

#include <string>
#include <vector>

#include "case.hpp"
#include "parapet/flow/flow.hpp"

namespace parapet::validation {

struct ParticlePanel {
  std::string title;                     // for example "t = 0.4 s"
  std::vector<double> x, z;              // [m]
  std::vector<double> quantity;          // what the colour shows, in the picture's unit
  std::vector<solver::Face> walls = {};  // besides the picture's
};

struct ParticlePicture {
  std::string title;
  std::string quantity;                 // beside the colour bar, for example "speed [m/s]"
  double low = 0.0, high = 0.0;         // ends of the colour bar; equal: from the data
  double spacing = 0.0;                 // of the particles [m]
  std::vector<solver::Face> walls;      // drawn where the window shows them
  solver::Vec2 window_from, window_to;  // corners of what is shown [m]; equal: from the data
  std::vector<ParticlePanel> panels;
  int columns = 0;  // 0: all panels in one row
  int width_px = 1100;
};

// The fluid as it is now; quantity: speed [m/s].
ParticlePanel speed_panel(const solver::Flow& flow, std::string title);
// The same with the pressure over `scale` [Pa].
ParticlePanel pressure_panel(const solver::Flow& flow, std::string title, double scale);

// Writes CASE_file_name; the card lists it. Axes have the same scale.
void draw(CaseRun& run, std::string_view file_name, const ParticlePicture& picture);

}  // namespace parapet::validation
