/// The only place that calls NLopt.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "evaluation_ledger.hpp"

namespace parapet::optimizer {

/// NLopt refused its set-up or ended with an error of its own.
struct NloptFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One run of one NLopt algorithm in the unit box.
struct SearchRequest {
  std::string algorithm;        ///< NLopt's full name, for example "LN_COBYLA"
  std::string local_algorithm;  ///< full name, where the algorithm needs one
  std::vector<double> start;    ///< [n], in [0, 1]
  int n_constraints = 0;        ///< of the replies, passed on as g <= 0
  double initial_step = 0.25;
  double tolerance = 1e-3;  ///< absolute, on every coordinate
  double constraint_tolerance = 0.0;
  int population = 0;        ///< 0: NLopt's own choice
  int evaluation_limit = 0;  ///< only for AGS, which has no other way to stop
  std::uint64_t seed = 1;
};

struct SearchOutcome {
  bool converged = false;  ///< NLopt ended by itself, with success or at the roundoff limit
  std::string code;        ///< NLopt's return code in its own words
  std::vector<double> u;   ///< [n], where NLopt says the optimum is; not to be trusted
};

/// The values at u; called once per point even though NLopt asks objective and constraints apart.
using AnswerQuery = std::function<Reply(const std::vector<double>& u)>;

/// Runs NLopt. An exception of `answer` (a StopSearch too) ends the run: NLopt is stopped, its
/// memory freed, and the exception thrown on from here.
///
/// The random numbers are NLopt's own generator, one per thread, seeded here by `seed`: the same
/// request and answers give the same queries, to the bit, whatever other threads do. An `answer`
/// must not run another randomized NLopt search on the same thread.
SearchOutcome run_nlopt(const SearchRequest& request, const AnswerQuery& answer);

/// Whether this NLopt was built with the algorithm (AGS is left out of some builds).
bool nlopt_has(const std::string& algorithm);

}  // namespace parapet::optimizer
