// The first look at the candidates of a neighbour row: cells lie one behind the other, so that
// eight particles are looked at in one load.
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

// Writes those of eight consecutive numbers that are to be kept, and says how many; may write all
// eight.
PARAPET_INLINE int keep_some(std::int32_t first, v8m keep, std::int32_t* out) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
  const __mmask8 mask = _mm512_movepi64_mask((__m512i)keep);
  const __m256i numbers =
      _mm256_add_epi32(_mm256_set1_epi32(first), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_maskz_compress_epi32(mask, numbers));
  return __builtin_popcount(mask);
#else
  int count = 0;
  for (int l = 0; l < lanes; ++l) {
    out[count] = first + l;
    count -= static_cast<int>(keep[l]);  // -1 where true
  }
  return count;
#endif
}

PARAPET_INLINE v8d whole_number(v8d v) {
  v8d r;
  for (int l = 0; l < lanes; ++l) r[l] = __builtin_round(v[l]);
  return r;
}

}  // namespace

int pick_near(const NearCandidates& c, std::int32_t* out) {
  constexpr v8m lane = {0, 1, 2, 3, 4, 5, 6, 7};
  const v8d x = splat(c.at_x), z = splat(c.at_z), limit = splat(c.distance2);
  int count = 0;
  for (int first = c.begin; first < c.end; first += lanes) {
    const Group group(first, c.end);
    v8d rx = x - group.load(c.x);
    if (c.period > 0.0) rx -= c.period * whole_number(rx / splat(c.period));
    const v8d rz = z - group.load(c.z);
    const v8m keep = (rx * rx + rz * rz < limit) & (lane < group.count) & (lane != c.self - first);
    count += keep_some(first, keep, out + count);
  }
  return count;
}

}  // namespace parapet::solver::PARAPET_ISA
