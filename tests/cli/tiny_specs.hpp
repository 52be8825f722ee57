/// Specs of a few dozen particles and half a second of flow: real simulations that take a moment.
#pragma once

#include "parapet/designs/case_spec.hpp"

namespace parapet::test {

/// A barrier with a deflector close to a small block of debris.
designs::Json tiny_case();

/// Makes the run of a case fail: one iteration cannot bring the viscous solve below its tolerance.
void make_unsolvable(designs::Json& case_json);

/// Two variables of that case, a constraint that needs no simulation and one that does.
designs::Json tiny_study();

/// The same variables for the Bayesian search: two objectives, three scenarios, twelve designs.
designs::Json tiny_search();

/// Three rows of that case: "bare", "lifted" and "flat".
designs::Json tiny_sweep();

}  // namespace parapet::test
