// The smallest use of the installed solver: an open channel, coarse, for a twentieth of a second.
#include <cstdio>
#include <string>

#include "parapet/solver/simulation.hpp"

int main() {
  parapet::solver::Scene scene;
  parapet::solver::Numerics numerics;
  numerics.spacing = 0.025;
  parapet::solver::RunOptions options;
  options.stop_time = 0.05;

  const auto result = parapet::solver::simulate(scene, numerics, options);
  const bool ran = result.status == parapet::solver::Status::ok && result.statistics.steps > 0 &&
                   result.stop_time > 0.99 * options.stop_time;
  std::printf("status %s after %.4f s in %lld steps%s%s\n",
              std::string(to_string(result.status)).c_str(), result.stop_time,
              static_cast<long long>(result.statistics.steps), result.reason.empty() ? "" : ": ",
              result.reason.c_str());
  return ran ? 0 : 1;
}
