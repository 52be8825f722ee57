/// A scene as drawings and players need it: corners instead of angles and rules.
#pragma once

#include "parapet/designs/case_spec.hpp"
#include "parapet/solver/scene.hpp"

namespace parapet::records {

/// {slope_deg, gravity_m_s2, domain {length_m, height_m}, reservoir {length_m, height_m},
/// monitor_x_m, density_kg_m3, barriers, solids}. Each barrier has its dimensions and `outline`,
/// the corners of barrier_outline; each solid is a list of its corners. Corners are [x, z] in
/// channel axes [m].
designs::Json scene_json(const solver::Scene& scene);

}  // namespace parapet::records
