#include "parapet/records/scene_json.hpp"

#include <numbers>

namespace parapet::records {
namespace {

using designs::Json;

constexpr double degree = std::numbers::pi / 180.0;

Json corners_json(const std::vector<solver::Vec2>& corners) {
  Json json = Json::array();
  for (const solver::Vec2& corner : corners) json.push_back({corner.x, corner.z});
  return json;
}

Json barrier_json(const solver::Scene& scene, const solver::Barrier& barrier) {
  Json json{{"foot_x_m", barrier.foot_x},
            {"height_m", barrier.height},
            {"thickness_m", barrier.thickness},
            {"stem_lean_deg", barrier.stem_lean / degree},
            {"deflector", nullptr},
            {"outline", corners_json(barrier_outline(scene, barrier))}};
  if (barrier.deflector) {
    json["deflector"] = {{"angle_deg", barrier.deflector->angle / degree},
                         {"length_m", barrier.deflector->length}};
  }
  return json;
}

}  // namespace

Json scene_json(const solver::Scene& scene) {
  Json barriers = Json::array(), solids = Json::array();
  for (const solver::Barrier& one : scene.barriers) barriers.push_back(barrier_json(scene, one));
  for (const solver::SolidPolygon& one : scene.solids) {
    solids.push_back(corners_json(one.vertices));
  }
  return {
      {"slope_deg", scene.slope / degree},
      {"gravity_m_s2", scene.gravity},
      {"domain", {{"length_m", scene.domain_length}, {"height_m", scene.domain_height}}},
      {"reservoir", {{"length_m", scene.reservoir_length}, {"height_m", scene.reservoir_height}}},
      {"monitor_x_m", scene.monitor_x},
      {"density_kg_m3", scene.material.density},
      {"barriers", std::move(barriers)},
      {"solids", std::move(solids)}};
}

}  // namespace parapet::records
