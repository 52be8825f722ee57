// Those of eight numbers for which something is true.
#pragma once

#include "simd.hpp"

namespace parapet::solver {

typedef std::int32_t v8i __attribute__((vector_size(32)));

// One bit for each lane in which a < b.
PARAPET_INLINE unsigned less(v8d a, v8d b) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
  return _mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_LT_OQ);
#else
  const v8m is_less = a < b;
  unsigned mask = 0;
  for (int l = 0; l < lanes; ++l) mask |= static_cast<unsigned>(is_less[l] & 1) << l;
  return mask;
#endif
}

// The bit of a lane; none for what is not a lane.
PARAPET_INLINE unsigned bit_of(int lane) {
  return static_cast<unsigned>(lane) < lanes ? 1U << lane : 0U;
}

// Those of the first `count` lanes.
PARAPET_INLINE unsigned first_bits(int count) {
  return count < lanes ? (1U << count) - 1 : ~0U;
}

// Writes the numbers that the mask names, and says how many; may write all eight.
PARAPET_INLINE int keep_some(v8i numbers, unsigned mask, std::int32_t* out) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out),
                      _mm256_maskz_compress_epi32(static_cast<__mmask8>(mask), (__m256i)numbers));
  return __builtin_popcount(mask);
#else
  // Every number is written and the next one over it unless it was kept: a branch would be guessed
  // wrong too often.
  int count = 0;
  for (int l = 0; l < lanes; ++l) {
    out[count] = numbers[l];
    count += static_cast<int>(mask >> l & 1);
  }
  return count;
#endif
}

}  // namespace parapet::solver
