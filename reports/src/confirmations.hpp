/// What confirmations.jsonl says of the designs that a rule ranks first.
#pragma once

#include "design_choice.hpp"
#include "parapet/study/confirmation.hpp"

namespace parapet::reports {

struct Confirmed {
  const Candidate* pick = nullptr;                ///< null when nothing is ranked
  study::Verdict verdict = study::Verdict::none;  ///< of the pick
  /// Designs that the rule prefers and that were refuted, in the rule's order.
  std::vector<const Candidate*> refuted = {};
};

/// The first design that is not refuted, among the first `most_confirmed_designs`; when all of
/// these are refuted, the rule's first again.
Confirmed confirmed_pick(const StudyLog& log, const Choice& choice);

/// {verdict, runs [...], spread [...], refuted [...]} of the pick; shape in confirmations.cpp.
designs::Json confirmation_json(const StudyLog& log, const Confirmed& confirmed);

}  // namespace parapet::reports
