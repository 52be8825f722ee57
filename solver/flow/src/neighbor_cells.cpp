// The fluid's cells behind the neighbour rows: particles sorted by cell at every build, and the
// bound on relative motion that says when the rows are outdated. Only cells that hold particles are
// kept, so that neither time nor memory grows with the empty part of the domain.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "parapet/flow/index.hpp"
#include "parapet/flow/neighbor_rows.hpp"

namespace parapet::solver {
namespace {

// Beyond it a place has no cell of its own: flows end long before.
constexpr double farthest_cell = 1e9;

// Particles of a cell are sorted by height, in so many layers: those of a group then have about as
// many neighbours, and wall points, as each other.
constexpr std::int64_t layers_of_cell = 4;

std::int64_t cell_along(double distance, double size) {
  return static_cast<std::int64_t>(
      std::clamp(std::floor(distance / size), -farthest_cell, farthest_cell));
}

}  // namespace

std::int64_t NeighborRows::Grid::column(double x) const {
  return cell_along(x - x0, cell_x);
}
std::int64_t NeighborRows::Grid::row(double z) const {
  return cell_along(z - z0, cell_z);
}

// Two particles have moved against each other by no more than the diagonal of the box that holds
// the displacements of both their cells; near a wall the box also holds zero. Cells up to two apart
// are compared. No particle may have moved by more than half a cell, so that those of cells three
// or more apart, and walls more than one and a half cells away, are still out of reach.
bool NeighborRows::outdated(const Fluid& fluid) const {
  if (!valid_) return true;
  constexpr double none = 1e300;
  motion_.resize(cells_.size());
  const double most = 0.25 * (reach_ + skin_) * (reach_ + skin_);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    double x_min = none, x_max = -none, z_min = none, z_max = -none;
    for (int i = cells_[c].begin; i < cells_[c].end; ++i) {
      double dx = fluid.x[at(i)] - built_x_[at(i)];
      if (periodic_length_ > 0.0) dx -= periodic_length_ * std::round(dx / periodic_length_);
      const double dz = fluid.z[at(i)] - built_z_[at(i)];
      x_min = std::min(x_min, dx);
      x_max = std::max(x_max, dx);
      z_min = std::min(z_min, dz);
      z_max = std::max(z_max, dz);
    }
    const double far_x = std::max(std::abs(x_min), std::abs(x_max));
    const double far_z = std::max(std::abs(z_min), std::abs(z_max));
    if (far_x * far_x + far_z * far_z > most) return true;
    if (cells_[c].near_wall) {
      x_min = std::min(x_min, 0.0);
      x_max = std::max(x_max, 0.0);
      z_min = std::min(z_min, 0.0);
      z_max = std::max(z_max, 0.0);
    }
    motion_[c] = {x_min, x_max, z_min, z_max};
  }
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const Motion& a = motion_[c];
    for (const CellRange& range : cells_[c].later) {
      for (int other = range.begin; other < range.end; ++other) {
        const Motion& b = motion_[at(other)];
        const double dx = std::max(a.x_max, b.x_max) - std::min(a.x_min, b.x_min);
        const double dz = std::max(a.z_max, b.z_max) - std::min(a.z_min, b.z_min);
        if (dx * dx + dz * dz > skin_ * skin_) return true;
      }
    }
  }
  return false;
}

// A stable sort of the particles by cell, eight bits of the cell's number at a time: its cost grows
// with the particles, and with the number of cells only as its logarithm does.
void NeighborRows::sort_by_cell(std::int64_t cells) {
  const std::size_t n = number_of_.size();
  order_.resize(n);
  for (std::size_t i = 0; i < n; ++i) order_[i] = static_cast<std::int32_t>(i);
  sorted_order_.resize(n);
  for (int shift = 0; shift < 64 && (cells - 1) >> shift > 0; shift += 8) {
    const auto digit = [&](std::int32_t i) {
      return static_cast<std::size_t>(number_of_[at(i)] >> shift) & 255U;
    };
    std::array<std::int32_t, 257> next{};
    for (const std::int32_t i : order_) ++next[digit(i) + 1];
    for (std::size_t d = 0; d < 256; ++d) next[d + 1] += next[d];
    for (const std::int32_t i : order_) sorted_order_[at(next[digit(i)]++)] = i;
    order_.swap(sorted_order_);
  }
}

void NeighborRows::place_grid(const Fluid& fluid) {
  const double cell = reach_ + skin_;
  const auto range = [&fluid](const std::vector<double>& places) {
    if (fluid.n == 0) return std::pair(0.0, 0.0);
    const auto [least, most] = std::minmax_element(places.begin(), places.begin() + fluid.n);
    return std::pair(*least, *most);
  };
  const auto [z_min, z_max] = range(fluid.z);
  grid_.cell_x = grid_.cell_z = cell;
  if (periodic_length_ > 0.0) {
    grid_.x0 = 0.0;
    grid_.nx = std::max<std::int64_t>(1, cell_along(periodic_length_, cell));
    grid_.cell_x = periodic_length_ / static_cast<double>(grid_.nx);
  } else {
    const auto [x_min, x_max] = range(fluid.x);
    grid_.x0 = x_min;
    grid_.nx = grid_.column(x_max) + 1;
  }
  grid_.z0 = z_min;
  grid_.nz = grid_.row(z_max) + 1;
}

// Finds the cells [z_from, z_to] of column ix, given where an earlier search ended.
NeighborRows::CellRange NeighborRows::cells_of_column(std::int64_t ix, std::int64_t z_from,
                                                      std::int64_t z_to, int& hint) const {
  const auto n = static_cast<int>(cells_.size());
  const std::int64_t from = grid_.cell(ix, std::max<std::int64_t>(0, z_from));
  const std::int64_t to = grid_.cell(ix, std::min(grid_.nz - 1, z_to));
  if (hint >= n || cells_[at(hint)].number > from) hint = 0;
  while (hint < n && cells_[at(hint)].number < from) ++hint;
  int end = hint;
  while (end < n && cells_[at(end)].number <= to) ++end;
  return {hint, end};
}

// Who is beside whom among the cells that hold particles.
void NeighborRows::link_cells() {
  const auto wrapped = [this](std::int64_t ix) {
    return periodic_length_ > 0.0 ? (ix + grid_.nx) % grid_.nx : ix;
  };
  std::array<int, 3> near_hint{};
  std::array<int, 2> later_hint{};
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    Cell& cell = cells_[c];
    const std::int64_t ix = cell.number / grid_.nz, iz = cell.number % grid_.nz;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t jx = wrapped(ix + static_cast<std::int64_t>(k) - 1);
      cell.near[k] = {0, 0};
      if (jx < 0 || jx >= grid_.nx) continue;
      const CellRange found = cells_of_column(jx, iz - 1, iz + 1, near_hint[k]);
      if (found.begin == found.end) continue;
      cell.near[k] = {cells_[at(found.begin)].begin, cells_[at(found.end - 1)].end};
    }
    const auto own = static_cast<int>(c);
    cell.later[0] = {own, own};
    while (at(cell.later[0].end) < cells_.size() &&
           cells_[at(cell.later[0].end)].number <= grid_.cell(ix, std::min(grid_.nz - 1, iz + 2))) {
      ++cell.later[0].end;
    }
    for (std::size_t k = 1; k < 3; ++k) {
      std::int64_t jx = ix + static_cast<std::int64_t>(k);
      if (periodic_length_ > 0.0 && jx >= grid_.nx) jx -= grid_.nx;
      cell.later[k] = {0, 0};
      if (jx < grid_.nx) cell.later[k] = cells_of_column(jx, iz - 2, iz + 2, later_hint[k - 1]);
    }
  }
}

// Whose neighbours stand where: particles of a layer are less than a cell's height from those four
// layers above and below alone.
void NeighborRows::link_layers() {
  const std::size_t n = number_of_.size();
  struct Layer {
    std::int64_t number;
    std::int32_t begin;
  };
  std::vector<Layer> layers;
  layer_of_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::int64_t number = number_of_[at(order_[k])];
    if (layers.empty() || layers.back().number != number) {
      layers.push_back({number, static_cast<std::int32_t>(k)});
    }
    layer_of_[k] = static_cast<std::int32_t>(layers.size()) - 1;
  }
  layers.push_back({std::int64_t{1} << 62, static_cast<std::int32_t>(n)});
  ranges_.assign(layers.size() - 1, {});
  const std::int64_t per_column = layers_of_cell * grid_.nz;
  std::array<std::size_t, 3> from{}, to{};
  for (std::size_t l = 0; l + 1 < layers.size(); ++l) {
    const std::int64_t ix = layers[l].number / per_column, iz = layers[l].number % per_column;
    for (std::size_t k = 0; k < 3; ++k) {
      std::int64_t jx = ix + static_cast<std::int64_t>(k) - 1;
      if (periodic_length_ > 0.0) jx = (jx + grid_.nx) % grid_.nx;
      if (jx < 0 || jx >= grid_.nx) continue;
      const std::int64_t low = jx * per_column + std::max<std::int64_t>(0, iz - layers_of_cell);
      const std::int64_t high = jx * per_column + std::min(per_column - 1, iz + layers_of_cell);
      if (layers[from[k]].number > low) from[k] = 0;
      if (layers[to[k]].number > high) to[k] = 0;
      while (layers[from[k]].number < low) ++from[k];
      while (layers[to[k]].number <= high) ++to[k];
      ranges_[l].begin[k] = layers[from[k]].begin;
      ranges_[l].end[k] = layers[to[k]].begin;
    }
  }
}

void NeighborRows::sort(Fluid& fluid) {
  const std::size_t n = at(fluid.n);
  place_grid(fluid);
  number_of_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t ix = std::clamp<std::int64_t>(grid_.column(fluid.x[i]), 0, grid_.nx - 1);
    const std::int64_t iz = grid_.row(fluid.z[i]);
    const double height = (fluid.z[i] - grid_.z0) / grid_.cell_z - static_cast<double>(iz);
    const auto layer =
        static_cast<std::int64_t>(std::clamp(height * layers_of_cell, 0.0, layers_of_cell - 1.0));
    number_of_[i] = layers_of_cell * grid_.cell(ix, iz) + layer;
  }
  sort_by_cell(layers_of_cell * grid_.nx * grid_.nz);
  fluid.permute(order_);
  cells_.clear();
  cell_of_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::int64_t number = number_of_[at(order_[k])] / layers_of_cell;
    if (cells_.empty() || cells_.back().number != number) {
      const auto first = static_cast<std::int32_t>(k);
      cells_.push_back({.number = number, .begin = first, .end = first});
    }
    Cell& cell = cells_.back();
    cell.end = static_cast<std::int32_t>(k) + 1;
    cell.near_wall = cell.near_wall || walls_may_be_reached({fluid.x[k], fluid.z[k]});
    cell_of_[k] = static_cast<std::int32_t>(cells_.size()) - 1;
  }
  link_cells();
  link_layers();
}

}  // namespace parapet::solver
