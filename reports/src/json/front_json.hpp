#pragma once

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// {id, design, objectives, probability_feasible, probability_limits, within_limits, score}
designs::Json to_json(const FrontDesign& design);

/// {objective, next {id, changes}, best {id, changes}}
designs::Json to_json(const WayOut& way);

/// {value, reference, history [{evaluations, cpu_time_s, hypervolume}]}
designs::Json to_json(const Progress& progress);

}  // namespace parapet::reports
