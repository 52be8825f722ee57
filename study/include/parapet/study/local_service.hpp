/// Simulations in threads of this program.
#pragma once

#include "parapet/study/simulation_service.hpp"
#include "parapet/study/simulator.hpp"

namespace parapet::study {

/// A service of as many threads as it has places, each of which simulates one task after the other.
/// What the simulator throws is a failure of the service.
ServiceFactory local_service(Simulator simulator = solver_simulator());

}  // namespace parapet::study
