#include "parapet/flow/wall_layout.hpp"

#include <cmath>
#include <utility>

#include "parapet/flow/index.hpp"
#include "wall_corners.hpp"

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

namespace {

// The walls' points face by face, those first whose grid fills the corners.
class Layout {
 public:
  Layout(const Solids& solids, double spacing, double reach)
      : solids_(solids),
        spacing_(spacing),
        layers_(static_cast<int>(std::ceil(reach / spacing))),
        past_(layers_ * spacing),
        ends_(faces_met(solids)),
        patches_(solids.faces.size()) {
    for (const int f : leading_first(solids)) {
      add_own(f);
      add_led(f);
    }
  }

  WallPoints points() const;

 private:
  const Face& face(int f) const { return solids_.faces[at(f)]; }
  Vec2 behind(int f) const { return -1.0 * face(f).normal; }
  Convex grid_for(int f, int end) const;
  void add_own(int f);
  void add_cell(int f, const Station& station, int layer);
  void add_led(int f);
  bool goes_on(int f, const Station& station, double depth) const;

  const Solids& solids_;
  double spacing_;
  int layers_;
  double past_;
  std::vector<FaceEnds> ends_;
  std::vector<std::vector<Patch>> patches_;  // [n_faces]
};

void Layout::add_own(int f) {
  const Face& own = face(f);
  std::vector<Station> stations;
  const bool whole = own.points_from == 0.0 && own.points_to == own.length;
  if (whole) {
    std::vector<Station> before;
    add_stations(before, 0.0, past_, spacing_);
    for (const Station& st : before) stations.push_back({-st.s, st.width});
  }
  add_stations(stations, own.points_from, own.points_to, spacing_);
  if (whole) add_stations(stations, own.length, own.length + past_, spacing_);
  for (const Station& station : stations) {
    for (int layer = 0; layer < layers_; ++layer) add_cell(f, station, layer);
  }
}

// What the grid of the face met at this end of f fills near f. Past its own other end it does so
// only where the wall goes on.
Convex Layout::grid_for(int f, int end) const {
  const int leading = ends_[at(f)][at(end)]->face;
  double past[2];
  for (const int k : {0, 1}) {
    const auto& met = ends_[at(leading)][at(k)];
    past[k] = !met || met->pocket || met->face == f ? past_ : 0.0;
  }
  return rectangle(face(leading), -past[0], face(leading).length + past[1], 0.0, past_);
}

// Where no other face is met: whether the wall goes on past the end.
bool Layout::goes_on(int f, const Station& station, double depth) const {
  const Face& own = face(f);
  if (station.s < 0.0 ? own.reaches_past_a : own.reaches_past_b) return true;
  const std::vector<Vec2>& outline = solids_.bodies[at(own.body)].outline;
  return !outline.empty() &&
         inside_polygon(outline, own.a + station.s * own.tangent - depth * own.normal);
}

void Layout::add_cell(int f, const Station& station, int layer) {
  const Face& own = face(f);
  const bool before = station.s<0.0, after = station.s> own.length;
  const double depth = layer * spacing_;
  Convex cell = rectangle(own, station.s - 0.5 * station.width, station.s + 0.5 * station.width,
                          depth, depth + spacing_);
  if (before || after) {
    const auto& met = ends_[at(f)][after ? 1 : 0];
    if (!met && !goes_on(f, station, depth + 0.5 * spacing_)) return;
    // past a corner of the solid only what is behind its other face
    if (met && !met->pocket) cell = cut(cell, face(met->face).a, behind(met->face));
  }
  std::vector<Convex> pieces{cell};
  for (const int end : {0, 1}) {
    const auto& met = ends_[at(f)][at(end)];
    if (!met || !met->leads) continue;
    const Convex grid = grid_for(f, end);
    std::vector<Convex> left;
    for (const Convex& piece : pieces) {
      for (Convex& part : without(piece, grid)) left.push_back(std::move(part));
    }
    pieces = std::move(left);
  }
  // Of a cell across the line of a face that it leads, that face gets the part behind it.
  std::vector<std::vector<Convex>> parts{pieces};
  for (const auto& met : ends_[at(f)]) {
    if (!met || met->leads || met->pocket) continue;
    std::vector<std::vector<Convex>> split;
    for (const std::vector<Convex>& part : parts) {
      for (const double side : {1.0, -1.0}) {
        split.emplace_back();
        for (const Convex& piece : part) {
          split.back().push_back(cut(piece, face(met->face).a, side * behind(met->face)));
        }
      }
    }
    parts = std::move(split);
  }
  const double whole = station.width * spacing_, middle = (layer + 0.5) * spacing_;
  for (const std::vector<Convex>& part : parts) {
    Patch patch = patch_of(part, own);
    if (std::abs(patch.area - whole) < 1e-9 * whole) {  // to the last bit wherever nothing is cut
      patch = {own.a + station.s * own.tangent - middle * own.normal, whole, middle};
    }
    if (patch.area > 1e-6 * spacing_ * spacing_) patches_[at(f)].push_back(patch);
  }
}

// What lies behind both faces of a corner is seen through either, and it must be the same: of the
// grid of the leading one the other has a copy.
void Layout::add_led(int f) {
  const Face& own = face(f);
  std::vector<Convex> had;
  for (const int end : {0, 1}) {
    const auto& met = ends_[at(f)][at(end)];
    if (!met || !met->leads) continue;
    const Convex grid = grid_for(f, end);
    for (const Patch& patch : patches_[at(met->face)]) {
      const Vec2 center = patch.center;
      const double depth = dot(own.a - center, own.normal);
      if (depth <= 0.0 || distance_to_segment(own.a, own.b, center) > past_ + spacing_) {
        continue;
      }
      const auto in = [&](const Convex& other) {
        for (std::size_t k = 0; k < other.size(); ++k) {
          if (cross(other[(k + 1) % other.size()] - other[k], center - other[k]) < 0.0)
            return false;
        }
        return true;
      };
      if (in(grid) && (had.empty() || !in(had.front())))
        patches_[at(f)].push_back({center, patch.area, depth});
    }
    had.push_back(grid);
  }
}

WallPoints Layout::points() const {
  std::vector<WallPoint> points;
  std::vector<int> owners;
  for (std::size_t f = 0; f < patches_.size(); ++f) {
    const Face& own = solids_.faces[f];
    for (const Patch& patch : patches_[f]) {
      points.push_back({.x = patch.center.x,
                        .z = patch.center.z,
                        .volume = patch.area,
                        .u = own.velocity.x,
                        .w = own.velocity.z,
                        .normal_x = own.normal.x,
                        .normal_z = own.normal.z,
                        .depth = patch.depth});
      owners.push_back(static_cast<int>(f));
    }
  }
  return {points, std::move(owners)};
}

}  // namespace

WallPoints lay_out_walls(const Solids& solids, double spacing, double reach) {
  return Layout(solids, spacing, reach).points();
}

}  // namespace parapet::solver
