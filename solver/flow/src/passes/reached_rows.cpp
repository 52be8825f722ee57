// Picks the pairs that the kernel reaches, once for all the sums of a step, from the particles that
// stand near by: sorted by cell, so that eight of them are looked at in one load.
#include "keep_some.hpp"
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

// Eight rows side by side: their next eight indices as eight slots.
PARAPET_INLINE void interleave(const std::int32_t* rows, int room, std::int32_t* out) {
  v8i r[lanes];
  for (int l = 0; l < lanes; ++l) __builtin_memcpy(&r[l], rows + l * room, sizeof r[l]);
  v8i a[lanes], b[lanes];
  for (int k = 0; k < 4; ++k) {
    a[2 * k] = __builtin_shufflevector(r[2 * k], r[2 * k + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    a[2 * k + 1] = __builtin_shufflevector(r[2 * k], r[2 * k + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (int k = 0; k < 2; ++k) {
    for (int m = 0; m < 2; ++m) {
      b[4 * k + 2 * m] =
          __builtin_shufflevector(a[4 * k + m], a[4 * k + 2 + m], 0, 1, 8, 9, 4, 5, 12, 13);
      b[4 * k + 2 * m + 1] =
          __builtin_shufflevector(a[4 * k + m], a[4 * k + 2 + m], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (int m = 0; m < 4; ++m) {
    const v8i low = __builtin_shufflevector(b[m], b[4 + m], 0, 1, 2, 3, 8, 9, 10, 11);
    const v8i high = __builtin_shufflevector(b[m], b[4 + m], 4, 5, 6, 7, 12, 13, 14, 15);
    __builtin_memcpy(out + lanes * m, &low, sizeof low);
    __builtin_memcpy(out + lanes * (4 + m), &high, sizeof high);
  }
}

// Which of eight places are within the reach of a particle, one bit each.
template <bool periodic>
PARAPET_INLINE unsigned within(const FlowConstants& c, v8d x, v8d z, v8d other_x, v8d other_z,
                               v8d reach2) {
  const v8d rx = nearest<periodic>(c, x - other_x), rz = z - other_z;
  return less(rx * rx + rz * rz, reach2);
}

// The neighbours of particle i among those of the cells beside it. Returns how many; may write a
// vector more.
template <bool periodic>
PARAPET_INLINE int found(const FlowArrays& a, const NearRanges near, int i, v8d reach2,
                         std::int32_t* out) {
  constexpr v8i lane = {0, 1, 2, 3, 4, 5, 6, 7};
  const FluidView& f = a.fluid;
  const v8d x = splat(f.x[i]), z = splat(f.z[i]);
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    const std::int32_t end = near.end[k];
    for (std::int32_t first = near.begin[k]; first < end; first += lanes) {
      unsigned mask;
      if (first + lanes <= f.n) [[likely]] {
        mask = within<periodic>(a.constants, x, z, load(f.x + first), load(f.z + first), reach2);
      } else {
        const Group last(first, f.n);
        mask = within<periodic>(a.constants, x, z, last.load(f.x), last.load(f.z), reach2);
      }
      mask &= first_bits(end - first) & ~bit_of(i - first);
      count += keep_some(first + lane, mask, out + count);
    }
  }
  return count;
}

// Likewise among the numbers of a list, whose length is a whole number of vectors.
template <bool periodic, class Element>
PARAPET_INLINE int listed(const FlowConstants& c, double at_x, double at_z, const Element* places,
                          const std::int32_t* list, int length, v8d reach2, std::int32_t* out) {
  const v8d x = splat(at_x), z = splat(at_z);
  int count = 0;
  for (int s = 0; s < length; s += lanes) {
    const TwoLanes other = gather_two(places, list + s);
    v8i numbers;
    __builtin_memcpy(&numbers, list + s, sizeof numbers);
    count += keep_some(numbers, within<periodic>(c, x, z, other.x, other.z, reach2), out + count);
  }
  return count;
}

// The rows of a group, before they stand side by side.
struct Rows {
  std::int32_t* scratch;
  int room, count[lanes];

  PARAPET_MEMBER std::int32_t* of(int lane) const { return scratch + lane * room; }

  // Puts them side by side, the shorter ones filled up with the ghost. Returns where they end; what
  // is written may end seven slots later.
  PARAPET_MEMBER std::int32_t* append(std::int32_t ghost, std::int32_t* out) const {
    const v8i ghosts = {ghost, ghost, ghost, ghost, ghost, ghost, ghost, ghost};
    int longest = 0;
    for (int l = 0; l < lanes; ++l) longest = count[l] > longest ? count[l] : longest;
    for (int l = 0; l < lanes; ++l) {
      for (int s = count[l]; s < longest; s += lanes) {
        __builtin_memcpy(of(l) + s, &ghosts, sizeof ghosts);
      }
    }
    for (int s = 0; s < longest; s += lanes) interleave(scratch + s, room, out + lanes * s);
    return out + lanes * longest;
  }
};

template <bool periodic>
void rows_of(const FlowArrays& a, const NearView& near, const ReachedRows& rows, int begin,
             int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  // rounding must not lose a pair that a sum would see; beyond the support its weight is zero
  const v8d reach2 = splat(4.0 * (1.0 + 1e-9) * c.smoothing_length * c.smoothing_length);
  std::int32_t* next = rows.index + rows.first;
  const auto place = [&] { return static_cast<std::int32_t>(next - rows.index); };
  for (int i = begin; i < end; i += lanes) {
    const int g = i / lanes, members = end - i < lanes ? end - i : lanes;
    Rows group{rows.scratch, rows.room, {}};
    const auto pick_listed = [&](const auto* places, std::int32_t from, std::int32_t to) {
      const int length = (to - from) / lanes;
      for (int l = 0; l < members; ++l) {
        group.count[l] =
            listed<periodic>(c, f.x[i + l], f.z[i + l], places, near.index + from + l * length,
                             length, reach2, group.of(l));
      }
    };
    if (near.listed[g]) {
      pick_listed(f.motion, near.begin[g], near.wall_begin[g]);
    } else {
      for (int l = 0; l < members; ++l) {
        group.count[l] =
            found<periodic>(a, near.ranges[near.layer[i + l]], i + l, reach2, group.of(l));
      }
    }
    rows.begin[g] = place();
    next = group.append(f.n, next);
    rows.wall_begin[g] = place();
    if (near.wall_begin[g] != near.end[g]) {
      pick_listed(a.wall.place, near.wall_begin[g], near.end[g]);
      next = group.append(a.wall.n, next);
    }
    rows.end[g] = place();
  }
}

}  // namespace

void reached_rows(const FlowArrays& a, const NearView& near, const ReachedRows& rows, int begin,
                  int end) {
  PARAPET_PASS(rows_of, a, near, rows, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
