// The vector operations of the conjugate gradients, four particles (eight values) at a time. Ranges
// begin at whole vectors; what pads the last one is zero and stays so.
#include "passes.hpp"
#include "simd.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

constexpr int pairs_per_vector = lanes / 2;

PARAPET_INLINE v8d load(const Pair* pairs) {
  return solver::load(&pairs->x);
}

PARAPET_INLINE void store(Pair* pairs, v8d v) {
  solver::store(&pairs->x, v);
}

// (x, z) -> (z, x)
PARAPET_INLINE v8d swap(v8d v) {
  return v8d{v[1], v[0], v[3], v[2], v[5], v[4], v[7], v[6]};
}

}  // namespace

DescentSums descend(const DescentView& d, double step, int begin, int end) {
  v8d product = splat(0.0), worst = product;
  const v8d alpha = splat(step);
  for (int i = begin; i < end; i += pairs_per_vector) {
    store(d.solution + i, load(d.solution + i) + alpha * load(d.direction + i));
    const v8d r = load(d.residual + i) - alpha * load(d.image + i);
    const v8d s = load(d.inverse_diagonal + i) * r + load(d.inverse_off + i) * swap(r);
    store(d.residual + i, r);
    store(d.preconditioned + i, s);
    product += r * s;
    const v8d r2 = r * r;
    const v8d error = (r2 + swap(r2)) * load(d.scale + i);
    // a residual that is not a number must not pass for a small one
    worst = !(error <= worst) ? error : worst;
  }
  DescentSums sums{sum_lanes(product), 0.0};
  for (int l = 0; l < lanes; ++l) sums.worst = !(worst[l] <= sums.worst) ? worst[l] : sums.worst;
  return sums;
}

void turn(const DescentView& d, double beta, int begin, int end) {
  const v8d b = splat(beta);
  for (int i = begin; i < end; i += pairs_per_vector) {
    store(d.direction + i, load(d.preconditioned + i) + b * load(d.direction + i));
  }
}

}  // namespace parapet::solver::PARAPET_ISA
