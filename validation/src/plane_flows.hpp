// Exact solutions of plane flows.
#pragma once

#include "parapet/solver/scene.hpp"

namespace parapet::validation {

// u = N/(N+1) (G/K)^(1/N) [(a - y_p)^m - (|y| - y_p)^m], m = 1 + 1/N, y_p = tau_y/G [m/s].
// gradient: G [Pa/m]; half: a [m]; y: distance from the middle [m].
double poiseuille_speed(const solver::Material& material, double gradient, double half, double y);

}  // namespace parapet::validation
