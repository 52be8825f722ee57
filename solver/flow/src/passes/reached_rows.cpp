// Neighbour rows with a skin hold half as many pairs again as the kernel reaches. This picks those
// that it does reach, once for all the sums of a step.
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

// Writes the indices that are to be kept, in their order, and says how many; may write all eight.
PARAPET_INLINE int keep_some(const std::int32_t* index, v8m keep, std::int32_t* out) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
  const __mmask8 mask = _mm512_movepi64_mask((__m512i)keep);
  const __m256i kept = _mm256_maskz_compress_epi32(
      mask, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index)));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), kept);
  return __builtin_popcount(mask);
#else
  int count = 0;
  for (int l = 0; l < lanes; ++l) {
    out[count] = index[l];
    count -= static_cast<int>(keep[l]);  // -1 where true
  }
  return count;
#endif
}

template <bool periodic>
void rows_of(const FlowArrays& a, const ReachedRows& rows, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  // rounding must not lose a pair that a sum would see; beyond the support its weight is zero
  const v8d reach2 = splat(4.0 * (1.0 + 1e-9) * c.smoothing_length * c.smoothing_length);
  std::int32_t next = begin < end ? a.rows.begin[begin] : 0;
  const auto pad = [&](std::int32_t from, std::int32_t ghost) {
    while ((next - from) % lanes != 0) rows.index[next++] = ghost;
  };
  for (int i = begin; i < end; ++i) {
    const std::int32_t first = next;
    for (int s = a.rows.begin[i]; s < a.rows.wall_begin[i]; s += lanes) {
      const std::int32_t* j = a.rows.index + s;
      const TwoLanes place = gather_two(f.motion, j);
      const PairGeometry g = pair_geometry<periodic>(c, f.x[i], f.z[i], place.x, place.z);
      next += keep_some(j, g.r2 < reach2, rows.index + next);
    }
    pad(first, f.n);
    const std::int32_t middle = next;
    for (int s = a.rows.wall_begin[i]; s < a.rows.end[i]; s += lanes) {
      const std::int32_t* k = a.rows.index + s;
      const TwoLanes place = gather_two(a.wall.place, k);
      const PairGeometry g = pair_geometry<periodic>(c, f.x[i], f.z[i], place.x, place.z);
      next += keep_some(k, g.r2 < reach2, rows.index + next);
    }
    pad(middle, a.wall.n);
    rows.begin[i] = first;
    rows.wall_begin[i] = middle;
    rows.end[i] = next;
  }
}

}  // namespace

void reached_rows(const FlowArrays& a, const ReachedRows& rows, int begin, int end) {
  PARAPET_PASS(rows_of, a, rows, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
