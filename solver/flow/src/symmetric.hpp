// A symmetric tensor of the plane.
#pragma once

#include <cmath>

#include "parapet/solver/vec2.hpp"

namespace parapet::solver {

// Below this the tensor of Eq. 8 says too little about the neighbourhood to be inverted: a lone
// pair or a thread of particles has an eigenvalue near zero.
constexpr double lambda_invertible = 0.15;

struct Symmetric {
  double xx, xz, zz;
  double smallest_eigenvalue() const {
    const double mean = 0.5 * (xx + zz), half = 0.5 * (xx - zz);
    return mean - std::sqrt(half * half + xz * xz);
  }
  Vec2 solve(Vec2 v) const {
    const double inverse = 1.0 / (xx * zz - xz * xz);
    return {inverse * (zz * v.x - xz * v.z), inverse * (xx * v.z - xz * v.x)};
  }
};

}  // namespace parapet::solver
