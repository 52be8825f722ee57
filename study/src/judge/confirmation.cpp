#include "parapet/study/confirmation.hpp"

namespace parapet::study {

bool confirms(const std::string& run_id, const std::string& pick_id) {
  return run_id.starts_with(pick_id + "-");
}

Verdict verdict_of(const std::string& pick_id, const std::vector<ConfirmationRun>& runs) {
  int near = 0, near_held = 0, others = 0, others_held = 0, tested = 0;
  for (const ConfirmationRun& run : runs) {
    if (!confirms(run.id, pick_id)) continue;
    const bool is_near = run.stage == confirmation_stage::near;
    ++(is_near ? near : others);
    if (run.feasible && run.as_predicted) ++(is_near ? near_held : others_held);
    tested += run.tested ? 1 : 0;
  }
  if (near + others == 0) return Verdict::none;
  const bool held = others_held == others && 2 * near_held >= near;
  if (!held) return Verdict::refuted;
  return tested > 0 ? Verdict::confirmed : Verdict::none;
}

}  // namespace parapet::study
