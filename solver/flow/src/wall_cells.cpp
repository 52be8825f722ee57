// The walls' cells: wall points and faces never move, so they are put into cells once. Only cells
// near a wall are kept.
#include "parapet/flow/wall_cells.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

struct Heights {
  double from, to;
};

// Heights over which the part of a face between two places along x runs.
Heights heights_between(const Face& face, double x_from, double x_to) {
  const Vec2 a = face.a, b = face.b;
  const double run = b.x - a.x;
  if (std::abs(run) < 1e-12 * (1.0 + std::abs(b.z - a.z))) {
    return {std::min(a.z, b.z), std::max(a.z, b.z)};
  }
  const auto height = [&](double x) {
    return a.z + std::clamp((x - a.x) / run, 0.0, 1.0) * (b.z - a.z);
  };
  const double first = height(x_from), last = height(x_to);
  return {std::min(first, last), std::max(first, last)};
}

}  // namespace

int WallCells::column(double x) const {
  return static_cast<int>(std::clamp(std::floor((x - x0_) / size_), -2.0, columns_ + 1.0));
}

int WallCells::row(double z) const {
  return static_cast<int>(std::clamp(std::floor((z - z0_) / size_), -2.0, rows_ + 1.0));
}

WallCells::WallCells(const Solids& solids, const WallPoints& walls, double size) : size_(size) {
  const std::size_t n = walls.size();
  if (n == 0) return;
  const auto range = [n](const std::vector<double>& places) {  // without the ghost's
    return std::minmax_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(n));
  };
  const auto [x_min, x_max] = range(walls.x);
  const auto [z_min, z_max] = range(walls.z);
  // Whole cells from the origin: what a barrier adds must not move the cells of the channel, whose
  // points would then be visited, and summed, in another order.
  x0_ = (std::floor(*x_min / size) - 2.0) * size;
  z0_ = (std::floor(*z_min / size) - 2.0) * size;
  columns_ = std::floor((*x_max - x0_) / size) + 3.0;
  rows_ = std::floor((*z_max - z0_) / size) + 3.0;
  std::vector<Place> places;
  for (std::size_t k = 0; k < n; ++k) places.push_back({column(walls.x[k]), row(walls.z[k])});
  const std::vector<std::vector<Near>> near = cells_near(solids);
  lay_out(places, near);
}

// Every cell that a face may be near, face by face. The distances are those between a face and the
// middle of a cell.
std::vector<std::vector<WallCells::Near>> WallCells::cells_near(const Solids& solids) const {
  const double half_diagonal = 0.5 * std::sqrt(2.0) * size_;
  const double farthest = 1.5 * size_ + half_diagonal;
  const auto n_columns = static_cast<int>(columns_), n_rows = static_cast<int>(rows_);
  std::vector<std::vector<Near>> near(solids.faces.size());
  for (std::size_t f = 0; f < solids.faces.size(); ++f) {
    const Face& face = solids.faces[f];
    const int first = std::max(0, column(std::min(face.a.x, face.b.x) - farthest) - 1);
    const int last = std::min(n_columns - 1, column(std::max(face.a.x, face.b.x) + farthest) + 1);
    for (int ix = first; ix <= last; ++ix) {
      const double middle = x0_ + (ix + 0.5) * size_;
      const Heights heights = heights_between(face, middle - farthest, middle + farthest);
      const int low = std::max(0, row(heights.from - farthest) - 1);
      const int high = std::min(n_rows - 1, row(heights.to + farthest) + 1);
      for (int iz = low; iz <= high; ++iz) {
        const Vec2 center{middle, z0_ + (iz + 0.5) * size_};
        const double distance = distance_to_segment(face.a, face.b, center);
        if (distance > farthest) continue;
        near[f].push_back({{ix, iz}, distance <= size_ + half_diagonal});
      }
    }
  }
  return near;
}

void WallCells::lay_out(const std::vector<Place>& points,
                        const std::vector<std::vector<Near>>& near) {
  std::vector<Place> all = points;
  for (const auto& of_face : near) {
    for (const Near& one : of_face) all.push_back(one.place);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  row_of_.reserve(all.size());
  column_start_.assign(static_cast<std::size_t>(columns_) + 1, 0);
  for (const Place& place : all) {
    ++column_start_[at(place.ix) + 1];
    row_of_.push_back(place.iz);
  }
  for (std::size_t c = 1; c < column_start_.size(); ++c) column_start_[c] += column_start_[c - 1];

  start_.assign(all.size() + 1, 0);
  std::vector<std::int32_t> cell_of;
  for (const Place& place : points) {
    cell_of.push_back(cell(place.ix, place.iz));
    ++start_[at(cell_of.back()) + 1];
  }
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  sorted_.resize(points.size());
  std::vector<std::int32_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t k = 0; k < points.size(); ++k) {
    sorted_[at(next[at(cell_of[k])]++)] = static_cast<std::int32_t>(k);
  }

  faces_.resize(all.size());
  near_wall_.assign(all.size(), 0);
  for (std::size_t f = 0; f < near.size(); ++f) {
    for (const Near& one : near[f]) {
      const std::size_t c = at(cell(one.place.ix, one.place.iz));
      near_wall_[c] = 1;
      if (one.in_reach) faces_[c].push_back(static_cast<int>(f));
    }
  }
}

std::int32_t WallCells::first_cell(int ix, int iz) const {
  const auto begin = row_of_.begin() + column_start_[at(ix)];
  const auto end = row_of_.begin() + column_start_[at(ix) + 1];
  return static_cast<std::int32_t>(std::lower_bound(begin, end, iz) - row_of_.begin());
}

std::int32_t WallCells::cell(int ix, int iz) const {
  if (ix < 0 || at(ix) + 1 >= column_start_.size()) return -1;
  const std::int32_t c = first_cell(ix, iz);
  return c < column_start_[at(ix) + 1] && row_of_[at(c)] == iz ? c : -1;
}

const std::vector<int>& WallCells::faces_near(Vec2 p) const {
  const std::int32_t c = cell(column(p.x), row(p.z));
  return c < 0 ? no_faces_ : faces_[at(c)];
}

bool WallCells::may_be_reached_from(Vec2 p) const {
  const std::int32_t c = cell(column(p.x), row(p.z));
  return c >= 0 && near_wall_[at(c)] != 0;
}

std::span<const std::int32_t> WallCells::points(int ix, int z_from, int z_to) const {
  if (ix < 0 || at(ix) + 1 >= column_start_.size()) return {};
  const std::int32_t from = first_cell(ix, z_from), to = first_cell(ix, z_to + 1);
  return {sorted_.data() + start_[at(from)], sorted_.data() + start_[at(to)]};
}

}  // namespace parapet::solver
