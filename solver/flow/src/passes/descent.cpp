// What the conjugate gradients do to each particle between two products.
#include "passes.hpp"
#include "simd.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

// D^-1 r
PARAPET_INLINE TwoLanes preconditioned(const DescentView& d, const Group& group, v8d rx, v8d rz) {
  const v8d xz = group.load(d.inverse_xz);
  return {group.load(d.inverse_xx) * rx + xz * rz, xz * rx + group.load(d.inverse_zz) * rz};
}

}  // namespace

DescentSums descend(const DescentView& d, double step, int begin, int end) {
  v8d product = splat(0.0), worst = product;
  const v8d alpha = splat(step);
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const auto direction = group.load(d.direction);
    group.store(d.u, group.load(d.u) + alpha * direction.u);
    group.store(d.w, group.load(d.w) + alpha * direction.w);
    const v8d rx = group.load(d.residual_x) - alpha * group.load(d.image_x);
    const v8d rz = group.load(d.residual_z) - alpha * group.load(d.image_z);
    group.store(d.residual_x, rx);
    group.store(d.residual_z, rz);
    const TwoLanes s = preconditioned(d, group, rx, rz);
    product += rx * s.x + rz * s.z;
    const v8d error = (rx * rx + rz * rz) * group.load(d.scale);
    // a residual that is not a number must not pass for a small one
    worst = !(error <= worst) ? error : worst;
  }
  DescentSums sums{sum_lanes(product), 0.0};
  for (int l = 0; l < lanes; ++l) sums.worst = !(worst[l] <= sums.worst) ? worst[l] : sums.worst;
  return sums;
}

void turn(const DescentView& d, double beta, int begin, int end) {
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const TwoLanes s = preconditioned(d, group, group.load(d.residual_x), group.load(d.residual_z));
    for (int l = 0; l < group.count; ++l) {
      MotionRecord& direction = d.direction[i + l];
      direction.u = s.x[l] + beta * direction.u;
      direction.w = s.z[l] + beta * direction.w;
    }
  }
}

}  // namespace parapet::solver::PARAPET_ISA
