// The cells behind the neighbour rows: walls put into cells once, fluid sorted by cell at every
// build, and the bound on relative motion that says when the rows are outdated.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "parapet/flow/index.hpp"
#include "parapet/flow/neighbor_rows.hpp"

namespace parapet::solver {

int NeighborRows::Grid::column(double x) const {
  return static_cast<int>(std::floor((x - x0) / cell_x));
}
int NeighborRows::Grid::row(double z) const {
  return static_cast<int>(std::floor((z - z0) / cell_z));
}

// Wall points and faces never move: they are put into cells once.
void NeighborRows::prepare_walls() {
  const double cell = reach_ + skin_;
  const std::size_t n = walls_.size();
  if (n == 0) {
    wall_start_.assign(2, 0);
    cell_faces_.resize(1);
    wall_grid_.x0 = wall_grid_.z0 = 1e9;
    return;
  }
  const auto range = [n](const std::vector<double>& places) {  // without the ghost's
    return std::minmax_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(n));
  };
  const auto [x_min, x_max] = range(walls_.x);
  const auto [z_min, z_max] = range(walls_.z);
  wall_grid_ = {*x_min - 2.0 * cell, *z_min - 2.0 * cell, cell, cell, 1, 1};
  wall_grid_.nx = wall_grid_.column(*x_max) + 3;
  wall_grid_.nz = wall_grid_.row(*z_max) + 3;
  const std::size_t cells = at(wall_grid_.nx) * at(wall_grid_.nz);
  wall_start_.assign(cells + 1, 0);
  std::vector<std::size_t> cell_of(n);
  for (std::size_t k = 0; k < n; ++k) {
    cell_of[k] = wall_grid_.cell(wall_grid_.column(walls_.x[k]), wall_grid_.row(walls_.z[k]));
    ++wall_start_[cell_of[k] + 1];
  }
  for (std::size_t c = 0; c < cells; ++c) wall_start_[c + 1] += wall_start_[c];
  wall_sorted_.resize(n);
  std::vector<std::int32_t> next(wall_start_.begin(), wall_start_.end() - 1);
  for (std::size_t k = 0; k < n; ++k) {
    wall_sorted_[at(next[cell_of[k]]++)] = static_cast<std::int32_t>(k);
  }
  cell_faces_.resize(cells);
  cell_near_wall_.assign(cells, 0);
  const double half_diagonal = 0.5 * std::sqrt(2.0) * cell;
  for (int ix = 0; ix < wall_grid_.nx; ++ix) {
    for (int iz = 0; iz < wall_grid_.nz; ++iz) {
      const Vec2 center{wall_grid_.x0 + (ix + 0.5) * cell, wall_grid_.z0 + (iz + 0.5) * cell};
      for (std::size_t f = 0; f < solids_.faces.size(); ++f) {
        const Face& face = solids_.faces[f];
        const double distance = distance_to_segment(face.a, face.b, center);
        if (distance <= 1.5 * cell + half_diagonal) cell_near_wall_[wall_grid_.cell(ix, iz)] = 1;
        if (distance <= cell + half_diagonal) {
          cell_faces_[wall_grid_.cell(ix, iz)].push_back(static_cast<int>(f));
        }
      }
    }
  }
}

const std::vector<int>& NeighborRows::faces_near(Vec2 p) const {
  const int ix = wall_grid_.column(p.x), iz = wall_grid_.row(p.z);
  if (ix < 0 || iz < 0 || ix >= wall_grid_.nx || iz >= wall_grid_.nz) return no_faces_;
  return cell_faces_[wall_grid_.cell(ix, iz)];
}

bool NeighborRows::wall_may_be_reached(Vec2 p) const {
  const int ix = wall_grid_.column(p.x), iz = wall_grid_.row(p.z);
  if (ix < 0 || iz < 0 || ix >= wall_grid_.nx || iz >= wall_grid_.nz) return false;
  return !cell_near_wall_.empty() && cell_near_wall_[wall_grid_.cell(ix, iz)] != 0;
}

// Two particles have moved against each other by no more than the diagonal of the box that holds
// the displacements of both their cells; near a wall the box also holds zero. Cells up to two apart
// are compared. No particle may have moved by more than half a cell, so that those of cells three
// or more apart, and walls more than one and a half cells away, are still out of reach.
bool NeighborRows::outdated(const Fluid& fluid) const {
  if (!valid_) return true;
  constexpr double none = 1e300;
  const std::size_t cells = at(grid_.nx) * at(grid_.nz);
  motion_.assign(4 * cells, 0.0);
  std::vector<double>& m = motion_;
  for (std::size_t c = 0; c < cells; ++c) {
    double x_min = none, x_max = -none, z_min = none, z_max = -none;
    for (int i = start_[c]; i < start_[c + 1]; ++i) {
      double dx = fluid.x[at(i)] - built_x_[at(i)];
      if (periodic_length_ > 0.0) dx -= periodic_length_ * std::round(dx / periodic_length_);
      const double dz = fluid.z[at(i)] - built_z_[at(i)];
      x_min = std::min(x_min, dx);
      x_max = std::max(x_max, dx);
      z_min = std::min(z_min, dz);
      z_max = std::max(z_max, dz);
    }
    const double most = 0.25 * (reach_ + skin_) * (reach_ + skin_);
    const double far_x = std::max(std::abs(x_min), std::abs(x_max));
    const double far_z = std::max(std::abs(z_min), std::abs(z_max));
    if (start_[c] < start_[c + 1] && far_x * far_x + far_z * far_z > most) return true;
    if (start_[c] < start_[c + 1] && near_wall_[c]) {
      x_min = std::min(x_min, 0.0);
      x_max = std::max(x_max, 0.0);
      z_min = std::min(z_min, 0.0);
      z_max = std::max(z_max, 0.0);
    }
    m[4 * c] = x_min;
    m[4 * c + 1] = x_max;
    m[4 * c + 2] = z_min;
    m[4 * c + 3] = z_max;
  }
  static constexpr std::array<std::array<int, 2>, 13> half{{{0, 0},
                                                            {0, 1},
                                                            {0, 2},
                                                            {1, -2},
                                                            {1, -1},
                                                            {1, 0},
                                                            {1, 1},
                                                            {1, 2},
                                                            {2, -2},
                                                            {2, -1},
                                                            {2, 0},
                                                            {2, 1},
                                                            {2, 2}}};
  for (const std::int32_t c : occupied_) {
    const int ix = c / grid_.nz, iz = c % grid_.nz;
    for (const auto& [sx, sz] : half) {
      int jx = ix + sx;
      const int jz = iz + sz;
      if (periodic_length_ > 0.0 && jx >= grid_.nx) jx -= grid_.nx;
      if (jx >= grid_.nx || jz < 0 || jz >= grid_.nz) continue;
      const double* a = &m[4 * at(c)];
      const double* b = &m[4 * grid_.cell(jx, jz)];
      if (b[0] > b[1]) continue;  // empty
      const double dx = std::max(a[1], b[1]) - std::min(a[0], b[0]);
      const double dz = std::max(a[3], b[3]) - std::min(a[2], b[2]);
      if (dx * dx + dz * dz > skin_ * skin_) return true;
    }
  }
  return false;
}

void NeighborRows::sort(Fluid& fluid) {
  const double cell = reach_ + skin_;
  const std::size_t n = at(fluid.n);
  const auto range = [&fluid](const std::vector<double>& places) {
    if (fluid.n == 0) return std::pair(0.0, 0.0);
    const auto [least, most] = std::minmax_element(places.begin(), places.begin() + fluid.n);
    return std::pair(*least, *most);
  };
  const auto [z_min, z_max] = range(fluid.z);
  grid_.cell_x = grid_.cell_z = cell;
  if (periodic_length_ > 0.0) {
    grid_.x0 = 0.0;
    grid_.nx = std::max(1, static_cast<int>(std::floor(periodic_length_ / cell)));
    grid_.cell_x = periodic_length_ / grid_.nx;
  } else {
    const auto [x_min, x_max] = range(fluid.x);
    grid_.x0 = x_min;
    grid_.nx = grid_.column(x_max) + 1;
  }
  grid_.z0 = z_min;
  grid_.nz = grid_.row(z_max) + 1;
  const std::size_t cells = at(grid_.nx) * at(grid_.nz);
  start_.assign(cells + 1, 0);
  cell_of_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int ix = std::clamp(grid_.column(fluid.x[i]), 0, grid_.nx - 1);
    const std::size_t c = grid_.cell(ix, grid_.row(fluid.z[i]));
    cell_of_[i] = static_cast<std::int32_t>(c);
    ++start_[c + 1];
  }
  for (std::size_t c = 0; c < cells; ++c) start_[c + 1] += start_[c];
  order_.resize(n);
  next_.assign(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < n; ++i) {
    order_[at(next_[at(cell_of_[i])]++)] = static_cast<std::int32_t>(i);
  }
  fluid.permute(order_);
  occupied_.clear();
  near_wall_.assign(cells, 0);
  for (std::size_t c = 0; c < cells; ++c) {
    if (start_[c] < start_[c + 1]) occupied_.push_back(static_cast<std::int32_t>(c));
    for (int i = start_[c]; i < start_[c + 1] && near_wall_[c] == 0; ++i) {
      near_wall_[c] = wall_may_be_reached({fluid.x[at(i)], fluid.z[at(i)]});
    }
  }
}

}  // namespace parapet::solver
