#include "pass_cost.hpp"

#include <array>
#include <cstdlib>

namespace parapet::bench {
namespace {

// Additions, multiplications, divisions and square roots count one each; comparisons, masks and
// sign changes nothing, and neither does what is done once per particle. Common subexpressions
// count once.
//
// Geometry of a pair (pair_geometry.hpp): r 2; r^2 3; root 1; q 1; t 2; F 3. Loads: index 4 bytes,
// x and z 16.
constexpr double geometry = 12, geometry_bytes = 4 + 16;
constexpr double kernel_w = 6;            // simd.hpp
constexpr double value = sizeof(double);  // one gathered quantity

constexpr std::array<PassCost, 9> table{{
    // fluid and wall: p_j + p_i 1, F V 1, product 1, two sums 4; p, V
    {"pressure_force", geometry + 7, geometry + 7, geometry_bytes + 2 * value,
     geometry_bytes + 2 * value, 4, 8 * value},
    // fluid: F V 1, du and dw 2, dot product 3, times F V 1, sum 1; slopes 2, dot product 3;
    // difference 1, times 2 1, plus slope 1, times F V 1, sum 1; shifting: its divergence 7, flux
    // of
    // mass 8, three sums 5; V, u, w, rho, grad rho, shift
    // wall: dv 2, dot product with n 3, n . r 3, F V 1, two products 2, sum 1, shifting 7; n, u, w,
    // V
    {"density_rate", geometry + 38, geometry + 19, geometry_bytes + 8 * value,
     geometry_bytes + 5 * value, 4, 15 * value},
    // B: F V 1, grad W 2, three sums 6; shifting: W 6, ratio 1, weight 4, two sums 4; velocity
    // gradient 8: together 32. Fourth moments: weight 3, p 3, q 2, three sums 9, approach 3, its
    // sum
    // 3: together 23. fluid besides: du and dw 2, drho 1, times F V 1, two sums 4; V, u, w, rho
    // wall besides: height 4, floor 2, ratio 2, velocity 4; depth, n, u, w, V
    {"gradient_sums", geometry + 32 + 23 + 8, geometry + 32 + 23 + 12, geometry_bytes + 4 * value,
     geometry_bytes + 6 * value, 4, 24 * value},
    // fluid: u_ij 2, dot product 3, mean viscosity 2, F V 1, guard 1, division 1, products 2, sums
    // 4;
    // u, w, eta, V. wall: linear extension 9 more, no mean; u, w, n, depth, V
    {"viscous_force", geometry + 16, geometry + 23, geometry_bytes + 4 * value,
     geometry_bytes + 6 * value, 4, 11 * value},
    // fluid: mean 2, V V 1, product 1, guard 1, division 1, products 2, sums 8; eta, V; writes s.
    // wall: weight 5, linear extension 9, drive 4, its sums 4, sums 8; u, w, n, depth, V
    {"viscous_matrix", geometry + 16, geometry + 30, geometry_bytes + 2 * value + 4,
     geometry_bytes + 6 * value, 4 + 4, 13 * value},
    // fluid alone: r 2, differences 2, dot product 3, times s 1, two sums 4; index, s, x, z, v
    {"viscous_product", 12, 0, 4 + 4 + 4 * value, 0, 4 + 4, 9 * value},
    // wall alone: W 6, rho W 1, sums of W 1, p 2, head 4; rho, p
    {"extrapolate_walls", 0, geometry + kernel_w + 8, 0, geometry_bytes + 2 * value, 4, 3 * value},
    // wall alone: F V V 2, pressure 2, approach 5, linear extension 9, viscous part 6, sums 4; V,
    // p,
    // u, w, eta
    {"wall_load", 0, geometry + 28, 0, geometry_bytes + 5 * value, 4, 8 * value},
    // pressure_force and density_rate, each pair counted once
    {"pressure_and_continuity", 2 * geometry + 45, 2 * geometry + 26,
     2 * geometry_bytes + 10 * value, 2 * geometry_bytes + 7 * value, 8, 23 * value},
}};

}  // namespace

const PassCost& pass_cost(std::string_view name) {
  for (const PassCost& cost : table) {
    if (cost.name == name) return cost;
  }
  std::abort();
}

}  // namespace parapet::bench
