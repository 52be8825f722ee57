// What the cases share: time loops and orders of convergence.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "case.hpp"
#include "parapet/flow/flow.hpp"
#include "parapet/flow/totals.hpp"
#include "parapet/flow/walls.hpp"

namespace parapet::validation {

class Balance;

// Steps until `time` [s]. Throws std::runtime_error with the reason when the flow fails.
// balance: is told of every step.
void advance(solver::Flow& flow, double time, const CaseRun& run, Balance* balance = nullptr);

// Steps until `end` and calls `sample` at the start and at every multiple of `interval` [s].
void advance_sampled(solver::Flow& flow, double end, double interval, const CaseRun& run,
                     const std::function<void(solver::Flow&)>& sample, Balance* balance = nullptr);

using solver::Totals;

// Slope of log(error) against log(spacing), least squares.
double fitted_order(std::span<const double> spacings, std::span<const double> errors);

// sqrt(mean((a - b)^2)).
double rms_difference(std::span<const double> a, std::span<const double> b);

}  // namespace parapet::validation
