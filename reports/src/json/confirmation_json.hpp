#pragma once

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// {verdict, runs [...], spread [...], refuted [...]}
designs::Json to_json(const Confirmation& confirmation);

}  // namespace parapet::reports
