/// Seeded points of the unit cube, the same with every standard library.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

namespace parapet::surrogate {

/// Uniform in (0, 1): the upper 52 bits of a draw, and a half (53 and a half could round to 1).
double uniform(std::mt19937_64& generator);

/// n points of the unit cube [n, dimension], coordinates in (0, 1). The first 21 coordinates are
/// Sobol' points, corner included, under a random digital shift (each coordinate's bits XOR one
/// random word): they keep their even spread and each point is uniform. Further coordinates are
/// independent and uniform.
Eigen::MatrixXd unit_points(int n, int dimension, std::uint64_t seed);

}  // namespace parapet::surrogate
