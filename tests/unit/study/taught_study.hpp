/// A study in memory whose runs are formulas with a scatter of known size, and its surrogates.
#pragma once

#include <string>

#include "parapet/study/loaded_study.hpp"

namespace parapet::test {

/// Height (0.04 to 0.1 m) and angle (0 to 60 degrees) of a barrier with a deflector. Retention is
/// to be maximised, the launch length limited.
class TaughtStudy {
 public:
  /// @param spacings finest first [m]
  /// @param noise known s.d. of retention and of launch length at each spacing; negative: unknown
  TaughtStudy(const std::vector<double>& spacings, double launch_limit,
              double retention_noise = -1.0, double launch_noise = -1.0);

  /// A run as the log holds it.
  records::EvaluationRecord record(const std::string& id, double height, double angle,
                                   double spacing, double retention, double launch) const;
  /// A design of the study; its id is returned.
  std::string add(double height, double angle, double spacing, double retention, double launch);
  /// A run of confirmations.jsonl of that design: `role` as in "near-1".
  void confirm(const std::string& id, const std::string& role, const std::string& stage,
               double spacing, double retention, double launch);
  /// Fits the surrogates to the designs, as `parapet optimize` does; returns surrogates.json.
  designs::Json teach();

  study::LoadedStudy study;
};

}  // namespace parapet::test
