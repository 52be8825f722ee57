// The first look at the candidates of a neighbour row: cells lie one behind the other, so that
// eight particles are looked at in one load.
#include "keep_some.hpp"
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

PARAPET_INLINE v8d whole_number(v8d v) {
  v8d r;
  for (int l = 0; l < lanes; ++l) r[l] = __builtin_round(v[l]);
  return r;
}

}  // namespace

int pick_near(const NearCandidates& c, std::int32_t* out) {
  constexpr v8i lane = {0, 1, 2, 3, 4, 5, 6, 7};
  const v8d x = splat(c.at_x), z = splat(c.at_z), limit = splat(c.distance2);
  int count = 0;
  for (int first = c.begin; first < c.end; first += lanes) {
    const Group group(first, c.end);
    v8d rx = x - group.load(c.x);
    if (c.period > 0.0) rx -= c.period * whole_number(rx / splat(c.period));
    const v8d rz = z - group.load(c.z);
    const unsigned near =
        less(rx * rx + rz * rz, limit) & first_bits(group.count) & ~bit_of(c.self - first);
    count += keep_some(first + lane, near, out + count);
  }
  return count;
}

}  // namespace parapet::solver::PARAPET_ISA
