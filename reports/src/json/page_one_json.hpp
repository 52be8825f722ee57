#pragma once

#include "parapet/designs/case_spec.hpp"
#include "parapet/reports/page_one.hpp"

namespace parapet::reports {

designs::Json to_json(const PageOne& page);

/// What a repeat gives, a document for each quantity.
designs::Json repeat_json(const std::vector<study::Expectation>& repeat);

}  // namespace parapet::reports
