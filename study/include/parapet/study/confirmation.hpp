/// confirmations.jsonl: the recommended design simulated again, and designs very near to it.
#pragma once

#include <string>
#include <vector>

namespace parapet::study {

/// Stages of the lines in confirmations.jsonl.
namespace confirmation_stage {
inline constexpr const char* finest = "confirm-finest";    ///< at the study's finest spacing
inline constexpr const char* spacing = "confirm-spacing";  ///< at a spacing that the user gave
inline constexpr const char* near = "confirm-near";        ///< a design very near to it
}  // namespace confirmation_stage

/// Designs that are confirmed at most before giving up.
constexpr int most_confirmed_designs = 3;

/// What the verdict needs of a line.
struct ConfirmationRun {
  std::string id;  ///< PICK-finest, PICK-2.5mm, PICK-near-1, ...
  std::string stage;
  bool feasible = false;     ///< ended well and met every constraint
  bool as_predicted = true;  ///< no objective is worse than its prediction's 95 % interval
  bool tested = true;        ///< a constraint or a prediction could have failed
};

/// What the further simulations say of a design.
enum class Verdict {
  none,       ///< nothing was simulated again, or nothing could be tested by it
  confirmed,  ///< the design held wherever it was simulated again, and most near designs did
  refuted
};

/// A design is refuted when it fails, breaks a constraint or is worse than predicted at another
/// spacing, or when more than half of the designs near to it do. Runs that could test nothing (no
/// constraint needs a simulation, and nothing was predicted) confirm nothing.
Verdict verdict_of(const std::string& pick_id, const std::vector<ConfirmationRun>& runs);

/// Whether a line with this id is about the design `pick_id`.
bool confirms(const std::string& run_id, const std::string& pick_id);

}  // namespace parapet::study
