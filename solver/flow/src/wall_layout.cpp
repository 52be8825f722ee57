#include "parapet/flow/wall_layout.hpp"

#include <cmath>
#include <utility>

namespace parapet::solver {
namespace {

struct Station {
  double s;      // along the face [m]
  double width;  // share of the face that the point stands for [m]
};

// Stations over [from, to], the last one partial.
void add_stations(std::vector<Station>& stations, double from, double to, double spacing) {
  const double n = std::floor((to - from) / spacing + 1e-9);
  for (int k = 0; k < static_cast<int>(n); ++k) {
    stations.push_back({from + (k + 0.5) * spacing, spacing});
  }
  const double left = (to - from) - n * spacing;
  if (left > 1e-6 * spacing) stations.push_back({to - 0.5 * left, left});
}

}  // namespace

WallPoints::WallPoints(std::span<const WallPoint> points, std::vector<int> owners)
    : owner(std::move(owners)) {
#define PARAPET_FILL(name, ghost)                                   \
  for (const WallPoint& point : points) name.push_back(point.name); \
  name.push_back(ghost);
  PARAPET_WALL_FIELDS(PARAPET_FILL)
#undef PARAPET_FILL
  for (std::size_t k = 0; k <= points.size(); ++k) {
#define PARAPET_PACK(name, Type, a, b, c, d) \
  records.name.push_back({.a = a[k], .b = b[k], .c = c[k], .d = d[k]});
    PARAPET_WALL_RECORDS(PARAPET_PACK)
#undef PARAPET_PACK
  }
  for (auto* a : {&pressure, &mirrored_u, &mirrored_w}) a->assign(points.size() + 1, 0.0);
}

WallView WallPoints::view() {
  WallView view;
  view.n = static_cast<int>(size());
#define PARAPET_POINT(name, ...) view.name = name.data();
  PARAPET_WALL_FIELDS(PARAPET_POINT)
#undef PARAPET_POINT
#define PARAPET_POINT(name, ...) view.name = records.name.data();
  PARAPET_WALL_RECORDS(PARAPET_POINT)
#undef PARAPET_POINT
  view.pressure = pressure.data();
  view.mirrored_u = mirrored_u.data();
  view.mirrored_w = mirrored_w.data();
  return view;
}

WallPoints lay_out_walls(const Solids& solids, double spacing, double reach) {
  std::vector<WallPoint> points;
  std::vector<int> owners;
  const int layers = static_cast<int>(std::ceil(reach / spacing));
  const double past = layers * spacing;
  for (std::size_t f = 0; f < solids.faces.size(); ++f) {
    const Face& face = solids.faces[f];
    const bool whole = face.points_from == 0.0 && face.points_to == face.length;
    std::vector<Station> stations;
    if (whole) {
      std::vector<Station> before;
      add_stations(before, 0.0, past, spacing);
      for (const Station& st : before) stations.push_back({-st.s, st.width});
    }
    add_stations(stations, face.points_from, face.points_to, spacing);
    if (whole) add_stations(stations, face.length, face.length + past, spacing);
    for (const Station& station : stations) {
      for (int layer = 0; layer < layers; ++layer) {
        const double depth = (layer + 0.5) * spacing;
        const Vec2 p = face.a + station.s * face.tangent - depth * face.normal;
        // past an end the point exists where the wall goes on: behind the neighbour of a pocket,
        // or inside the own body
        const bool before = station.s<0.0, after = station.s> face.length;
        const bool goes_on = (before && face.reaches_past_a) || (after && face.reaches_past_b);
        const std::vector<Vec2>& outline =
            solids.bodies[static_cast<std::size_t>(face.body)].outline;
        if ((before || after) && !goes_on && (outline.empty() || !inside_polygon(outline, p))) {
          continue;
        }
        points.push_back({.x = p.x,
                          .z = p.z,
                          .volume = station.width * spacing,
                          .u = face.velocity.x,
                          .w = face.velocity.z,
                          .normal_x = face.normal.x,
                          .normal_z = face.normal.z,
                          .depth = depth});
        owners.push_back(static_cast<int>(f));
      }
    }
  }
  return {points, std::move(owners)};
}

}  // namespace parapet::solver
