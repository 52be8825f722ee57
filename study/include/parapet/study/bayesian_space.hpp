/// The variables of a study as the space of the Bayesian search.
#pragma once

#include "parapet/bayesian/problem.hpp"
#include "parapet/designs/study_spec.hpp"

namespace parapet::study {

/// The space of a study's variables, in their order.
bayesian::Space make_space(const designs::StudySpec& study);

/// Point of a design, inactive variables NaN.
bayesian::Point to_point(const designs::StudySpec& study, const designs::Design& design);

/// The design of a point; inactive variables are left out.
designs::Design to_design(const designs::StudySpec& study, const bayesian::Space& space,
                          const bayesian::Point& point);

}  // namespace parapet::study
