#include <cmath>

#include "parapet/flow/flow.hpp"

namespace parapet::solver {
namespace {

bool sound(const InitialParticle& p) {
  return std::isfinite(p.x + p.z + p.u + p.w) && p.density > 0.0 && std::isfinite(p.density) &&
         p.mass > 0.0 && std::isfinite(p.mass);
}

}  // namespace

std::vector<std::string> setup_errors(const FlowSetup& setup) {
  std::vector<std::string> errors;
  if (setup.threads < 1) {
    errors.push_back("threads is " + std::to_string(setup.threads) + "; allowed: at least 1");
  }
  if (setup.n_barriers < 0) {
    errors.push_back("n_barriers is " + std::to_string(setup.n_barriers) + "; allowed: at least 0");
  }
  const auto n_bodies = static_cast<int>(setup.solids.bodies.size());
  for (std::size_t k = 0; k < setup.solids.faces.size(); ++k) {
    const Face& face = setup.solids.faces[k];
    const std::string of = "faces[" + std::to_string(k) + "].";
    if (face.body < 0 || face.body >= n_bodies) {
      errors.push_back(of + "body is " + std::to_string(face.body) + "; there are " +
                       std::to_string(n_bodies) + " bodies");
    }
    if (face.barrier < -1 || face.barrier >= setup.n_barriers) {
      errors.push_back(
          of + "barrier is " + std::to_string(face.barrier) +
          "; allowed: -1, or less than n_barriers = " + std::to_string(setup.n_barriers));
    }
  }
  for (std::size_t i = 0; i < setup.particles.size(); ++i) {
    if (sound(setup.particles[i])) continue;
    errors.push_back("particles[" + std::to_string(i) +
                     "] must have finite places and velocities, and a density and a mass above 0");
    break;  // the others are most often wrong in the same way
  }
  return errors;
}

}  // namespace parapet::solver
