#include "parapet/flow/neighbor_rows.hpp"

#include <algorithm>
#include <cmath>

#include "parallel.hpp"
#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

// Rows of a block of particles are joined to those of the others when so many blocks are complete:
// few enough that they take no memory to speak of.
constexpr int blocks_at_a_time = 64;

// Puts the rows of a group one after the other, as long as the longest, in whole vectors; the ghost
// fills them up. Returns how many indices that makes.
std::int32_t append(const std::array<std::vector<std::int32_t>, lanes>& rows, std::int32_t ghost,
                    std::vector<std::int32_t>& out) {
  std::size_t longest = 0;
  for (const auto& row : rows) longest = std::max(longest, row.size());
  const std::size_t length = at(lanes * groups_of(static_cast<int>(longest)));
  for (const auto& row : rows) {
    out.insert(out.end(), row.begin(), row.end());
    out.insert(out.end(), length - row.size(), ghost);
  }
  return static_cast<std::int32_t>(lanes * length);
}

}  // namespace

NeighborRows::NeighborRows(const Solids& solids, const WallPoints& walls, double reach, double skin,
                           double spacing, double periodic_length, const PassTable* passes)
    : solids_(solids),
      walls_(walls),
      passes_(passes ? *passes : best_passes()),
      reach_(reach),
      skin_(skin),
      spacing_(spacing),
      periodic_length_(periodic_length),
      wall_cells_(solids, walls, reach + skin) {}

// Of the faces near a place those that a pair within the rows' reach can have between it.
// Returns the distance of the nearest, at most the reach with its skin [m].
double NeighborRows::find_faces_in_reach(Vec2 p, std::vector<int>& in_reach) const {
  in_reach.clear();
  const double reach = (1.0 + 1e-9) * (reach_ + skin_);
  double nearest = reach;
  for (const int f : faces_near(p)) {
    const Face& face = solids_.faces[at(f)];
    const double distance = distance_to_segment(face.a, face.b, p);
    if (distance < reach) in_reach.push_back(f);
    nearest = std::min(nearest, distance);
  }
  return nearest;
}

bool NeighborRows::bodies_among(const std::vector<int>& faces) const {
  return std::any_of(faces.begin(), faces.end(), [&](int f) {
    return !solids_.bodies[at(solids_.faces[at(f)].body)].outline.empty();
  });
}

void NeighborRows::add_fluid_neighbors(const Fluid& fluid, int i, const std::vector<int>& faces,
                                       std::vector<std::int32_t>& out) const {
  const Vec2 p{fluid.x[at(i)], fluid.z[at(i)]};
  const double limit = (reach_ + skin_) * (reach_ + skin_);
  const bool bodies_near = bodies_among(faces);
  const auto offset = [&](std::int32_t j) {
    double rx = p.x - fluid.x[at(j)];
    if (periodic_length_ > 0.0) rx -= periodic_length_ * std::round(rx / periodic_length_);
    return Vec2{rx, p.z - fluid.z[at(j)]};
  };
  for (const auto& [from, to] : cells_[at(cell_of_[at(i)])].near) {
    if (from == to) continue;
    const std::size_t first = out.size();
    out.resize(first + at(to - from) + lanes);
    const int count = passes_.pick_near(
        {fluid.x.data(), fluid.z.data(), from, to, i, p.x, p.z, limit, periodic_length_},
        out.data() + first);
    out.resize(first + at(count));
    if (!bodies_near) continue;
    const auto out_of_sight = [&](std::int32_t j) {
      return hidden(solids_.faces, faces, p, p - offset(j), spacing_);
    };
    const auto column = out.begin() + static_cast<std::ptrdiff_t>(first);
    out.erase(std::remove_if(column, out.end(), out_of_sight), out.end());
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
        if (faces.size() == 1) {
          if (faces.front() == owner) out.push_back(k);
          continue;
        }
        // most points of other faces fail by their own face alone
        if (!crossing(solids_.faces[at(owner)], p, q)) continue;
        if (first_crossed(solids_.faces, faces, p, q) == owner) out.push_back(k);
      }
    }
  }
}

void NeighborRows::fill_block(const Fluid& fluid, int begin, int end, RowBuffer& buffer) {
  buffer.index.clear();
  buffer.fluid_count.clear();
  buffer.wall_count.clear();
  buffer.listed.clear();
  for (int first = begin; first < end; first += lanes) {
    for (auto& row : buffer.fluid) row.clear();
    for (auto& row : buffer.wall) row.clear();
    bool listed = false;
    for (int i = first; i < std::min(end, first + lanes); ++i) {
      std::vector<int>& faces = buffer.faces[at(i - first)];
      faces.clear();
      if (!cells_[at(cell_of_[at(i)])].near_wall) continue;
      clearance_[at(i)] = find_faces_in_reach({fluid.x[at(i)], fluid.z[at(i)]}, faces);
      add_wall_neighbors(fluid, i, faces, buffer.wall[at(i - first)]);
      listed = listed || bodies_among(faces);
    }
    for (int i = first; listed && i < std::min(end, first + lanes); ++i) {
      add_fluid_neighbors(fluid, i, buffer.faces[at(i - first)], buffer.fluid[at(i - first)]);
    }
    buffer.listed.push_back(listed);
    buffer.fluid_count.push_back(append(buffer.fluid, fluid.n, buffer.index));
    buffer.wall_count.push_back(append(buffer.wall, wall_ghost(), buffer.index));
  }
}

void NeighborRows::join(const RowBuffer& buffer) {
  auto slots = static_cast<std::int32_t>(index_.size());
  for (std::size_t k = 0; k < buffer.fluid_count.size(); ++k) {
    begin_.push_back(slots);
    slots += buffer.fluid_count[k];
    wall_begin_.push_back(slots);
    slots += buffer.wall_count[k];
    end_.push_back(slots);
  }
  index_.insert(index_.end(), buffer.index.begin(), buffer.index.end());
  listed_.insert(listed_.end(), buffer.listed.begin(), buffer.listed.end());
}

// Rows of the wall points: the same pairs seen from the other side.
void NeighborRows::transpose_wall_rows(int n) {
  // Calls body(i, k) for every pair of a particle and a wall point in its row.
  const auto for_pairs = [&](const auto& body) {
    for (int i = 0; i < n; ++i) {
      const std::size_t g = at(i / lanes);
      const std::int32_t length = (end_[g] - wall_begin_[g]) / lanes;
      const std::int32_t first = wall_begin_[g] + i % lanes * length;
      for (int s = first; s < first + length && index_[at(s)] != wall_ghost(); ++s) {
        body(i, index_[at(s)]);
      }
    }
  };
  std::vector<std::int32_t>& count = point_count_;
  count.resize(walls_.size() + 1, 0);
  // Only what the last rows touched is cleared, and only what these touch is visited: most of a
  // long channel's walls are far from the fluid.
  for (const std::int32_t k : active_) count[at(k)] = 0;
  active_.clear();
  for_pairs([&](int, std::int32_t k) {
    if (count[at(k)]++ == 0) active_.push_back(k);
  });
  std::sort(active_.begin(), active_.end());
  n_active_ = static_cast<int>(active_.size());
  active_.resize(at(lanes * groups_of(n_active_)), wall_ghost());
  point_begin_.assign(1, 0);
  for (int first = 0; first < n_active_; first += lanes) {
    std::int32_t longest = 0;
    for (int a = first; a < std::min(n_active_, first + lanes); ++a) {
      std::int32_t& of_point = count[at(active_[at(a)])];
      longest = std::max(longest, of_point);
      of_point = point_begin_.back() + a - first;  // from now on: its next free place
    }
    point_begin_.push_back(point_begin_.back() + lanes * longest);
  }
  point_index_.assign(at(point_begin_.back()), n);
  for_pairs([&](int i, std::int32_t k) {
    std::int32_t& place = count[at(k)];
    point_index_[at(place)] = i;
    place += lanes;
  });
}

void NeighborRows::build(Fluid& fluid, int threads) {
  sort(fluid);
  const int n = fluid.n;
  for (auto* array : {&begin_, &wall_begin_, &end_, &index_}) array->clear();
  listed_.clear();
  clearance_.assign(at(n), reach_ + skin_);
  buffers_.resize(blocks_at_a_time);
  constexpr int at_a_time = blocks_at_a_time * block_size;
  for (int from = 0; from < n; from += at_a_time) {
    const int count = std::min(n - from, at_a_time);
    for_blocks(count, threads, [&](int begin, int end) {
      fill_block(fluid, from + begin, from + end, buffers_[at(begin / block_size)]);
    });
    for (int begin = 0; begin < count; begin += block_size) join(buffers_[at(begin / block_size)]);
  }
  transpose_wall_rows(n);
  reserve_rows(n);
  built_x_.assign(fluid.x.begin(), fluid.x.begin() + n);
  built_z_.assign(fluid.z.begin(), fluid.z.begin() + n);
  valid_ = true;
}

// What the reached rows of every block of particles take at most.
void NeighborRows::reserve_rows(int n) {
  room_ = 0;
  std::vector<std::int32_t> candidates;
  for (const NearRanges& r : ranges_) {
    std::int32_t all = 0;
    for (int k = 0; k < 3; ++k) all += r.end[k] - r.begin[k];
    candidates.push_back(all);
  }
  block_first_.assign(1, 0);
  for (int begin = 0; begin < n; begin += block_size) {
    std::int32_t slots = lanes * lanes;  // the last interleaving may write so much more
    for (int first = begin; first < std::min(n, begin + block_size); first += lanes) {
      const std::size_t g = at(first / lanes);
      std::int32_t longest = 0;
      for (int i = first; i < std::min(n, first + lanes); ++i) {
        longest = std::max(longest, candidates[at(layer_of_[at(i)])]);
      }
      const std::int32_t fluid = listed_[g] ? wall_begin_[g] - begin_[g] : lanes * longest;
      const std::int32_t wall = end_[g] - wall_begin_[g];
      slots += fluid + wall;
      room_ = std::max(room_, std::max(fluid, wall) / lanes + 2 * lanes);
    }
    block_first_.push_back(block_first_.back() + slots);
  }
}

bool NeighborRows::touches_wall(int i) const {
  const std::size_t g = at(i / lanes);
  const std::int32_t length = (end_[g] - wall_begin_[g]) / lanes;
  return length > 0 && index_[at(wall_begin_[g] + i % lanes * length)] != wall_ghost();
}

bool NeighborRows::clear_of_faces(int i, Vec2 before, Vec2 after) const {
  constexpr double slack = 2e-9;  // [m] more than what crossing() allows beyond the ends of a face
  const double far = std::max(0.0, clearance_[at(i)] - slack);
  const Vec2 built{built_x_[at(i)], built_z_[at(i)]};
  const Vec2 from = before - built, to = after - built;
  return dot(from, from) < far * far && dot(to, to) < far * far;
}

NearView NeighborRows::view() const {
  return {ranges_.data(),     layer_of_.data(), listed_.data(), begin_.data(),
          wall_begin_.data(), end_.data(),      index_.data()};
}

RowView NeighborRows::wall_point_rows() const {
  return {
      nullptr,  nullptr, nullptr, nullptr, active_.data(), point_begin_.data(), point_index_.data(),
      n_active_};
}

}  // namespace parapet::solver
