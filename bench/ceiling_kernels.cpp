#include "ceiling_kernels.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace parapet::bench::PARAPET_ISA {
namespace {

// The registers of the instruction set, so that the accumulators stay in them.
#if defined(__AVX512F__)
constexpr int width = 8;
#elif defined(__AVX__)
constexpr int width = 4;
#else
constexpr int width = 2;
#endif
typedef double Vector __attribute__((vector_size(8 * width)));
constexpr int chains =
    12;  // multiplication and addition take six cycles or more, two start in each

#if defined(__AVX512F__)
#define PARAPET_FUSED(x, a, b) (Vector) _mm512_fmadd_pd((__m512d)(x), (__m512d)(a), (__m512d)(b))
#elif defined(__FMA__)
#define PARAPET_FUSED(x, a, b) (Vector) _mm256_fmadd_pd((__m256d)(x), (__m256d)(a), (__m256d)(b))
#endif

// x = step(x) in every chain; the sum keeps the compiler from dropping the work.
template <class Step>
double run_chains(std::size_t rounds, double* sink, const Step& step) {
  Vector x[chains];
  for (int k = 0; k < chains; ++k) x[k] = Vector{} + 1.0 + 0.01 * k;
  for (std::size_t r = 0; r < rounds; ++r) {
#pragma GCC unroll 12
    for (int k = 0; k < chains; ++k) x[k] = step(x[k]);
  }
  Vector all = x[0];
  for (int k = 1; k < chains; ++k) all += x[k];
  *sink = all[0];
  return 2.0 * chains * width * static_cast<double>(rounds);
}

double multiply_add(std::size_t rounds, double* sink) {
  const Vector a = Vector{} + 0.999999, b = Vector{} + 1e-6;
  return run_chains(rounds, sink, [=](Vector x) { return x * a + b; });
}

#if defined(PARAPET_FUSED)
double fused_multiply_add(std::size_t rounds, double* sink) {
  const Vector a = Vector{} + 0.999999, b = Vector{} + 1e-6;
  return run_chains(rounds, sink, [=](Vector x) { return PARAPET_FUSED(x, a, b); });
}
#endif

// As many as the register holds, one at a time, each from a new argument.
template <class Step>
double run_unpaired(std::size_t rounds, double* sink, const Step& step) {
  Vector sum = {}, x = Vector{} + 2.0;
  for (std::size_t r = 0; r < rounds; ++r) {
    x += Vector{} + 1e-3;
    sum += step(x);
  }
  *sink = sum[0];
  return static_cast<double>(width) * static_cast<double>(rounds);
}

Vector root(Vector x) {
#if defined(__AVX512F__)
  return (Vector)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
#elif defined(__AVX__)
  return (Vector)_mm256_sqrt_pd((__m256d)x);
#elif defined(__SSE2__)
  return (Vector)_mm_sqrt_pd((__m128d)x);
#else
  for (int l = 0; l < width; ++l) x[l] = __builtin_sqrt(x[l]);
  return x;
#endif
}

double roots(std::size_t rounds, double* sink) {
  return run_unpaired(rounds, sink, [](Vector x) { return root(x); });
}

double quotients(std::size_t rounds, double* sink) {
  return run_unpaired(rounds, sink, [](Vector x) { return 1.0 / x; });
}

double total(Vector v) {
  double sum = 0.0;
  for (int l = 0; l < width; ++l) sum += v[l];
  return sum;
}

double sum(const double* values, std::size_t n, std::size_t rounds) {
  constexpr std::size_t streams = 8;
  Vector s[streams] = {};
  for (std::size_t r = 0; r < rounds; ++r) {
    for (std::size_t k = 0; k < n; k += streams * width) {
#pragma GCC unroll 8
      for (std::size_t m = 0; m < streams; ++m) {
        Vector v;
        __builtin_memcpy(&v, values + k + m * width, sizeof v);
        s[m] += v;
      }
    }
  }
  for (std::size_t m = 1; m < streams; ++m) s[0] += s[m];
  return total(s[0]);
}

Vector gather(const double* values, const std::int32_t* index) {
  Vector v;
#pragma GCC unroll 8
  for (int l = 0; l < width; ++l) v[l] = values[index[l]];
  return v;
}

double gather_sum(const double* values, const std::int32_t* index, std::size_t n) {
  Vector a = {}, b = {};
  for (std::size_t k = 0; k < n; k += 2UL * width) {
    a += gather(values, index + k);
    b += gather(values, index + k + width);
  }
  return total(a + b);
}

}  // namespace

#define PARAPET_STRING_OF(x) #x
#define PARAPET_STRING(x) PARAPET_STRING_OF(x)

extern const CeilingKernels kernels;
const CeilingKernels kernels = {PARAPET_STRING(PARAPET_ISA),
                                multiply_add,
#if defined(PARAPET_FUSED)
                                fused_multiply_add,
#else
                                nullptr,
#endif
                                roots,
                                quotients,
                                sum,
                                gather_sum};

}  // namespace parapet::bench::PARAPET_ISA
