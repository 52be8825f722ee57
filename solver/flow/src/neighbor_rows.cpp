#include "parapet/flow/neighbor_rows.hpp"

#include <algorithm>
#include <cmath>

#include "parallel.hpp"
#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

// Rows are whole vectors: the rest of the last one points at the ghost.
void pad(std::vector<std::int32_t>& row, std::size_t from, std::int32_t ghost) {
  while ((row.size() - from) % lanes != 0) row.push_back(ghost);
}

bool blocked(const std::vector<Face>& faces, const std::vector<int>& near, Vec2 p, Vec2 q) {
  for (const int f : near) {
    const Face& face = faces[at(f)];
    if (crossing(face, p, q) || crossing(face, q, p)) return true;
  }
  return false;
}

}  // namespace

NeighborRows::NeighborRows(const Solids& solids, const WallPoints& walls, double reach, double skin,
                           double periodic_length)
    : solids_(solids),
      walls_(walls),
      reach_(reach),
      skin_(skin),
      periodic_length_(periodic_length),
      wall_cells_(solids, walls, reach + skin) {}

void NeighborRows::add_fluid_neighbors(const Fluid& fluid, int i, const std::vector<int>& faces,
                                       std::vector<std::int32_t>& out) const {
  const Vec2 p{fluid.x[at(i)], fluid.z[at(i)]};
  const double limit = (reach_ + skin_) * (reach_ + skin_);
  const bool bodies_near = std::any_of(faces.begin(), faces.end(), [&](int f) {
    return !solids_.bodies[at(solids_.faces[at(f)].body)].outline.empty();
  });
  const auto offset = [&](std::int32_t j) {
    double rx = p.x - fluid.x[at(j)];
    if (periodic_length_ > 0.0) rx -= periodic_length_ * std::round(rx / periodic_length_);
    return Vec2{rx, p.z - fluid.z[at(j)]};
  };
  for (const auto& [from, to] : cells_[at(cell_of_[at(i)])].near) {
    if (from == to) continue;
    // Every candidate is written and the next one over it unless it was near: a branch would be
    // guessed wrong too often.
    std::size_t count = out.size();
    const std::size_t first = count;
    out.resize(count + at(to - from));
    for (int j = from; j < to; ++j) {
      const Vec2 r = offset(j);
      out[count] = j;
      count += static_cast<std::size_t>((r.x * r.x + r.z * r.z < limit) & (j != i));
    }
    out.resize(count);
    if (!bodies_near) continue;
    const auto hidden = [&](std::int32_t j) {
      return blocked(solids_.faces, faces, p, p - offset(j));
    };
    const auto column = out.begin() + static_cast<std::ptrdiff_t>(first);
    out.erase(std::remove_if(column, out.end(), hidden), out.end());
  }
}

void NeighborRows::add_wall_neighbors(const Fluid& fluid, int i, const std::vector<int>& faces,
                                      std::vector<std::int32_t>& out) const {
  if (faces.empty()) return;
  const Vec2 p{fluid.x[at(i)], fluid.z[at(i)]};
  const double limit = (reach_ + skin_) * (reach_ + skin_);
  const int images = periodic_length_ > 0.0 ? 1 : 0;
  for (int image = -images; image <= images; ++image) {
    const double shift = image * periodic_length_;
    const int ix = wall_cells_.column(p.x + shift), iz = wall_cells_.row(p.z);
    for (int jx = ix - 1; jx <= ix + 1; ++jx) {
      for (const std::int32_t k : wall_cells_.points(jx, iz - 1, iz + 1)) {
        const Vec2 q{walls_.x[at(k)] - shift, walls_.z[at(k)]};
        const double rx = p.x - q.x, rz = p.z - q.z;
        if (rx * rx + rz * rz >= limit) continue;
        const int owner = walls_.owner[at(k)];
        const int seen =
            faces.size() == 1 ? faces.front() : first_crossed(solids_.faces, faces, p, q);
        if (seen == owner) out.push_back(k);
      }
    }
  }
}

void NeighborRows::fill_block(const Fluid& fluid, int begin, int end, RowBuffer& buffer) const {
  buffer.index.clear();
  buffer.fluid_count.clear();
  buffer.wall_count.clear();
  for (int i = begin; i < end; ++i) {
    const std::vector<int>& faces = faces_near({fluid.x[at(i)], fluid.z[at(i)]});
    const std::size_t first = buffer.index.size();
    add_fluid_neighbors(fluid, i, faces, buffer.index);
    pad(buffer.index, first, fluid.n);
    const std::size_t middle = buffer.index.size();
    add_wall_neighbors(fluid, i, faces, buffer.index);
    pad(buffer.index, middle, static_cast<std::int32_t>(walls_.size()));
    buffer.fluid_count.push_back(static_cast<std::int32_t>(middle - first));
    buffer.wall_count.push_back(static_cast<std::int32_t>(buffer.index.size() - middle));
  }
}

void NeighborRows::join(const std::vector<RowBuffer>& buffers, int n) {
  begin_.resize(at(n));
  wall_begin_.resize(at(n));
  end_.resize(at(n));
  std::size_t slots = 0, i = 0;
  for (const RowBuffer& buffer : buffers) {
    for (std::size_t k = 0; k < buffer.fluid_count.size(); ++k, ++i) {
      begin_[i] = static_cast<std::int32_t>(slots);
      slots += at(buffer.fluid_count[k]);
      wall_begin_[i] = static_cast<std::int32_t>(slots);
      slots += at(buffer.wall_count[k]);
      end_[i] = static_cast<std::int32_t>(slots);
    }
  }
  index_.resize(slots);
  auto out = index_.begin();
  for (const RowBuffer& buffer : buffers) {
    out = std::copy(buffer.index.begin(), buffer.index.end(), out);
  }
}

// Rows of the wall points: the same pairs seen from the other side.
void NeighborRows::transpose_wall_rows(int n) {
  const auto ghost = static_cast<std::int32_t>(walls_.size());
  std::vector<std::int32_t>& count = point_count_;
  count.resize(walls_.size() + 1, 0);
  // Only what the last rows touched is cleared, and only what these touch is visited: most of a
  // long channel's walls are far from the fluid.
  for (const std::int32_t k : active_) count[at(k)] = 0;
  active_.clear();
  for (int i = 0; i < n; ++i) {
    for (int s = wall_begin_[at(i)]; s < end_[at(i)]; ++s) {
      const std::int32_t k = index_[at(s)];
      if (k != ghost && count[at(k)]++ == 0) active_.push_back(k);
    }
  }
  std::sort(active_.begin(), active_.end());
  point_begin_.clear();
  point_end_.clear();
  std::int32_t slots = 0;
  for (const std::int32_t k : active_) {
    point_begin_.push_back(slots);
    const std::int32_t from = slots;
    slots += (count[at(k)] + lanes - 1) / lanes * lanes;
    point_end_.push_back(slots);
    count[at(k)] = from;  // from now on: the next free slot
  }
  point_index_.assign(at(slots), n);
  for (int i = 0; i < n; ++i) {
    for (int s = wall_begin_[at(i)]; s < end_[at(i)]; ++s) {
      const std::int32_t k = index_[at(s)];
      if (k != ghost) point_index_[at(count[at(k)]++)] = i;
    }
  }
}

void NeighborRows::build(Fluid& fluid, int threads) {
  sort(fluid);
  const int n = fluid.n;
  buffers_.resize(at((n + block_size - 1) / block_size));
  for_blocks(n, threads, [&](int begin, int end) {
    fill_block(fluid, begin, end, buffers_[at(begin / block_size)]);
  });
  join(buffers_, n);
  transpose_wall_rows(n);
  built_x_.assign(fluid.x.begin(), fluid.x.begin() + n);
  built_z_.assign(fluid.z.begin(), fluid.z.begin() + n);
  valid_ = true;
}

RowView NeighborRows::view() const {
  return {begin_.data(),       wall_begin_.data(),  end_.data(),
          index_.data(),       point_begin_.data(), point_end_.data(),
          point_index_.data(), active_.data(),      static_cast<int>(active_.size())};
}

}  // namespace parapet::solver
