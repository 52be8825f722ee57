// Eight doubles at a time, in every build: GCC and Clang lower the vector type to whatever the
// instruction set offers. Lanes and reduction order never change, so neither do the bits.
#pragma once

#include <cstdint>

#include "../kernel.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace parapet::solver {

typedef double v8d __attribute__((vector_size(64)));
typedef std::int64_t v8m __attribute__((vector_size(64)));

#define PARAPET_INLINE static inline __attribute__((always_inline))

PARAPET_INLINE v8d splat(double s) {
  return v8d{s, s, s, s, s, s, s, s};
}

PARAPET_INLINE v8d gather(const double* values, const std::int32_t* index) {
  return v8d{values[index[0]], values[index[1]], values[index[2]], values[index[3]],
             values[index[4]], values[index[5]], values[index[6]], values[index[7]]};
}

PARAPET_INLINE v8d load(const double* values) {
  v8d v;
  __builtin_memcpy(&v, values, sizeof v);
  return v;
}

PARAPET_INLINE void store(double* values, v8d v) {
  __builtin_memcpy(values, &v, sizeof v);
}

PARAPET_INLINE v8d positive_part(v8d v) {
  const v8m keep = v > splat(0.0);
  return (v8d)((v8m)v & keep);
}

// Correctly rounded in every instruction set (IEEE 754), so the lanes agree bit for bit.
PARAPET_INLINE v8d sqrt_lanes(v8d v) {
#if defined(__AVX512F__)
  return (v8d)_mm512_maskz_sqrt_pd(0xff, (__m512d)v);
#elif defined(__AVX__)
  union {
    v8d all;
    __m256d half[2];
  } u = {v};
  u.half[0] = _mm256_sqrt_pd(u.half[0]);
  u.half[1] = _mm256_sqrt_pd(u.half[1]);
  return u.all;
#elif defined(__SSE2__)
  union {
    v8d all;
    __m128d part[4];
  } u = {v};
  for (__m128d& part : u.part) part = _mm_sqrt_pd(part);
  return u.all;
#else
  v8d r = v;
  for (int l = 0; l < lanes; ++l) r[l] = __builtin_sqrt(v[l]);
  return r;
#endif
}

PARAPET_INLINE double sum_lanes(v8d v) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

// t = 1 - q/2, cut off at zero: both W and F vanish beyond the support without a branch.
PARAPET_INLINE v8d kernel_falloff(v8d q) {
  return positive_part(splat(1.0) - splat(0.5) * q);
}

PARAPET_INLINE v8d kernel_f(const Kernel& k, v8d t) {
  return splat(-k.f_scale) * (t * t * t);
}

PARAPET_INLINE v8d kernel_w(const Kernel& k, v8d q, v8d t) {
  const v8d t2 = t * t;
  return splat(k.alpha) * (t2 * t2) * (splat(2.0) * q + splat(1.0));
}

}  // namespace parapet::solver
