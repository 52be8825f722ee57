/// Where designs come from: the one interface between a search and the loop that evaluates.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"

namespace parapet::study {

/// A design to be evaluated.
struct Proposal {
  std::string stage;
  designs::Design design;
  double spacing = 0.0;  ///< [m]
};

/// Proposes designs and learns what became of them. One thread calls it.
class DesignSource {
 public:
  virtual ~DesignSource() = default;

  /// The next designs, in the order in which they are to be simulated; none while an answer must
  /// come first, or for good.
  virtual std::vector<Proposal> next() = 0;

  /// Whether nothing more comes until all that was proposed is answered. The simulations of such a
  /// round share the places of the service: where there are fewer, each takes several threads.
  virtual bool proposes_in_rounds() const { return false; }

  /// Whether next() answers at once, so that it may be asked before what has ended is on disk.
  virtual bool is_quick() const { return false; }

  /// The record of the proposal of this number, counted from 0 in the order of next().
  virtual void answered(std::size_t number, const records::EvaluationRecord& record) = 0;
};

}  // namespace parapet::study
