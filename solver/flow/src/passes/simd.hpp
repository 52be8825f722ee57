// Eight doubles at a time, in every build: GCC and Clang lower the vector type to whatever the
// instruction set offers. Lanes and reduction order never change, so neither do the bits.
#pragma once

#include <cstdint>

#include "parapet/flow/flow_arrays.hpp"
#include "parapet/flow/kernel.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace parapet::solver {

typedef double v8d __attribute__((vector_size(64)));
typedef double v4d __attribute__((vector_size(32)));
typedef float v8f __attribute__((vector_size(32)));
typedef std::int64_t v8m __attribute__((vector_size(64)));

#define PARAPET_MEMBER inline __attribute__((always_inline))
#define PARAPET_INLINE static PARAPET_MEMBER

PARAPET_INLINE v8d splat(double s) {
  return v8d{s, s, s, s, s, s, s, s};
}

PARAPET_INLINE v8d gather(const double* values, const std::int32_t* index) {
  return v8d{values[index[0]], values[index[1]], values[index[2]], values[index[3]],
             values[index[4]], values[index[5]], values[index[6]], values[index[7]]};
}

// The four values of eight records, by place and by name.
struct FourLanes {
  v8d a, b, c, d;
};
template <class Record>
struct Lanes;
#define PARAPET_LANES(name, Type, a, b, c, d) \
  template <>                                 \
  struct Lanes<Type> {                        \
    v8d a, b, c, d;                           \
  };
PARAPET_PARTICLE_RECORDS(PARAPET_LANES)
PARAPET_WALL_RECORDS(PARAPET_LANES)
#undef PARAPET_LANES

struct TwoLanes {
  v8d x, z;
};

// Records and pairs hold nothing but doubles.
template <class Element>
PARAPET_INLINE const double* values_of(const Element* elements, std::int32_t index) {
  return reinterpret_cast<const double*>(elements + index);
}

#if defined(__AVX512F__)
// Shuffles by the compiler: GCC 12 warns of its own 512-bit intrinsics (its bug 105593).
template <class Record>
PARAPET_INLINE FourLanes gather_four(const Record* records, const std::int32_t* index) {
  const auto two = [&](int first, int second) {
    const v4d low = (v4d)_mm256_load_pd(values_of(records, index[first]));
    const v4d high = (v4d)_mm256_load_pd(values_of(records, index[second]));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const v8d p0 = two(0, 2), p1 = two(1, 3), p2 = two(4, 6), p3 = two(5, 7);
  const v8d ac0 = __builtin_shufflevector(p0, p1, 0, 8, 2, 10, 4, 12, 6, 14);
  const v8d bd0 = __builtin_shufflevector(p0, p1, 1, 9, 3, 11, 5, 13, 7, 15);
  const v8d ac1 = __builtin_shufflevector(p2, p3, 0, 8, 2, 10, 4, 12, 6, 14);
  const v8d bd1 = __builtin_shufflevector(p2, p3, 1, 9, 3, 11, 5, 13, 7, 15);
  return {__builtin_shufflevector(ac0, ac1, 0, 1, 4, 5, 8, 9, 12, 13),
          __builtin_shufflevector(bd0, bd1, 0, 1, 4, 5, 8, 9, 12, 13),
          __builtin_shufflevector(ac0, ac1, 2, 3, 6, 7, 10, 11, 14, 15),
          __builtin_shufflevector(bd0, bd1, 2, 3, 6, 7, 10, 11, 14, 15)};
}

// The first two values of eight records, or eight pairs.
template <class Element>
PARAPET_INLINE TwoLanes gather_two(const Element* elements, const std::int32_t* index) {
  const auto four = [&](int first) {
    const auto at = [&](int k) { return _mm_load_pd(values_of(elements, index[first + k])); };
    const v4d low = (v4d)_mm256_insertf128_pd(_mm256_castpd128_pd256(at(0)), at(2), 1);
    const v4d high = (v4d)_mm256_insertf128_pd(_mm256_castpd128_pd256(at(4)), at(6), 1);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const v8d even = four(0), odd = four(1);
  return {__builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14),
          __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15)};
}
#elif defined(__AVX__)
PARAPET_INLINE v8d join(__m256d low, __m256d high) {
  const union {
    __m256d half[2];
    v8d all;
  } u = {{low, high}};
  return u.all;
}

template <class Record>
PARAPET_INLINE FourLanes gather_four(const Record* records, const std::int32_t* index) {
  __m256d a[2], b[2], c[2], d[2];
  for (int half = 0; half < 2; ++half) {
    const auto record = [&](int k) {
      return _mm256_load_pd(values_of(records, index[4 * half + k]));
    };
    const __m256d r0 = record(0), r1 = record(1), r2 = record(2), r3 = record(3);
    const __m256d ac0 = _mm256_unpacklo_pd(r0, r1), bd0 = _mm256_unpackhi_pd(r0, r1);
    const __m256d ac1 = _mm256_unpacklo_pd(r2, r3), bd1 = _mm256_unpackhi_pd(r2, r3);
    a[half] = _mm256_permute2f128_pd(ac0, ac1, 0x20);
    b[half] = _mm256_permute2f128_pd(bd0, bd1, 0x20);
    c[half] = _mm256_permute2f128_pd(ac0, ac1, 0x31);
    d[half] = _mm256_permute2f128_pd(bd0, bd1, 0x31);
  }
  return {join(a[0], a[1]), join(b[0], b[1]), join(c[0], c[1]), join(d[0], d[1])};
}

template <class Element>
PARAPET_INLINE TwoLanes gather_two(const Element* elements, const std::int32_t* index) {
  __m256d x[2], z[2];
  for (int half = 0; half < 2; ++half) {
    const auto two = [&](int first) {
      const auto at = [&](int k) {
        return _mm_load_pd(values_of(elements, index[4 * half + first + k]));
      };
      return _mm256_insertf128_pd(_mm256_castpd128_pd256(at(0)), at(2), 1);
    };
    const __m256d even = two(0), odd = two(1);
    x[half] = _mm256_unpacklo_pd(even, odd);
    z[half] = _mm256_unpackhi_pd(even, odd);
  }
  return {join(x[0], x[1]), join(z[0], z[1])};
}
#else
template <class Record>
PARAPET_INLINE FourLanes gather_four(const Record* records, const std::int32_t* index) {
  FourLanes r;
  for (int l = 0; l < lanes; ++l) {
    const double* value = values_of(records, index[l]);
    r.a[l] = value[0];
    r.b[l] = value[1];
    r.c[l] = value[2];
    r.d[l] = value[3];
  }
  return r;
}

template <class Element>
PARAPET_INLINE TwoLanes gather_two(const Element* elements, const std::int32_t* index) {
  TwoLanes r;
  for (int l = 0; l < lanes; ++l) {
    const double* value = values_of(elements, index[l]);
    r.x[l] = value[0];
    r.z[l] = value[1];
  }
  return r;
}
#endif

template <class Record>
PARAPET_INLINE Lanes<Record> gather(const Record* records, const std::int32_t* index) {
  const FourLanes r = gather_four(records, index);
  return {r.a, r.b, r.c, r.d};
}

PARAPET_INLINE v8d load(const double* values) {
  v8d v;
  __builtin_memcpy(&v, values, sizeof v);
  return v;
}

PARAPET_INLINE void store(double* values, v8d v) {
  __builtin_memcpy(values, &v, sizeof v);
}

// Kept as floats, computed with as doubles.
PARAPET_INLINE v8d load(const float* values) {
  v8f v;
  __builtin_memcpy(&v, values, sizeof v);
  return __builtin_convertvector(v, v8d);
}

PARAPET_INLINE void store(float* values, v8d v) {
  const v8f narrow = __builtin_convertvector(v, v8f);
  __builtin_memcpy(values, &narrow, sizeof narrow);
}

// Eight consecutive particles, one in each lane; fewer at the end of all. Lanes without a particle
// read zeros and write nothing.
struct Group {
  int first, count;
  Group(int begin, int end) : first(begin), count(end - begin < lanes ? end - begin : lanes) {}

  PARAPET_MEMBER v8d load(const double* values) const {
    if (count == lanes) return solver::load(values + first);
    v8d v = splat(0.0);
    for (int l = 0; l < count; ++l) v[l] = values[first + l];
    return v;
  }
  PARAPET_MEMBER void store(double* values, v8d v) const {
    if (count == lanes) return solver::store(values + first, v);
    for (int l = 0; l < count; ++l) values[first + l] = v[l];
  }
  // Of records with a ghost behind them: it is read where there is no particle.
  template <class Record>
  PARAPET_MEMBER Lanes<Record> load(const Record* records) const {
    std::int32_t index[lanes];
    for (int l = 0; l < lanes; ++l) index[l] = l < count ? l : count;
    return gather(records + first, index);
  }
};

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

// The same tree in every instruction set: lanes 4 apart, then 2, then 1.
PARAPET_INLINE double sum_lanes(v8d v) {
#if defined(__AVX__)
#if defined(__AVX512F__)
  const v4d low = __builtin_shufflevector(v, v, 0, 1, 2, 3);
  const v4d high = __builtin_shufflevector(v, v, 4, 5, 6, 7);
  const __m256d four = (__m256d)(low + high);
#else
  const union {
    v8d all;
    __m256d half[2];
  } u = {v};
  const __m256d four = _mm256_add_pd(u.half[0], u.half[1]);
#endif
  const __m128d two = _mm_add_pd(_mm256_castpd256_pd128(four), _mm256_extractf128_pd(four, 1));
  return _mm_cvtsd_f64(_mm_add_sd(two, _mm_unpackhi_pd(two, two)));
#else
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
#endif
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
