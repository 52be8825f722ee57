/// A list of simulations over a service.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "parapet/study/simulation_service.hpp"

namespace parapet::study {

/// Hands the tasks 0 .. count-1 in, in order, as many at a time as the service has places, where
/// nothing else may be under way.
/// @param begin the task of an index; empty where nothing is to be simulated
/// @param end takes the outcome of an index, in the order in which simulations end
/// @param stop asked before each task; true ends the handing in, and what runs is waited for
/// @throws what begin and end throw, and what went wrong in the service. It is to be closed then.
void simulate_in_order(
    SimulationService& service, std::size_t count,
    const std::function<std::optional<SimulationTask>(std::size_t index)>& begin,
    const std::function<void(std::size_t index, records::Simulation simulation)>& end,
    const std::function<bool()>& stop);

}  // namespace parapet::study
