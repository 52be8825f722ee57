/// A simulation's outcome on its way between machines.
#pragma once

#include "parapet/records/simulation.hpp"

namespace parapet::records {

/// Format "parapet-simulation-outcome/1". Nothing is lost on the way there and back: every bit of a
/// number, also of one that is not finite ("nan", "inf", "-inf"), the order of the metrics, and the
/// digits of the report.
designs::Json to_json(const Simulation& simulation);

/// @throws std::runtime_error or nlohmann::json::exception saying what is wrong.
Simulation simulation_from_json(const designs::Json& json);

}  // namespace parapet::records
