#include "study_facts.hpp"

#include <algorithm>
#include <map>

#include "design_advice.hpp"
#include "parapet/study/comparable.hpp"

namespace parapet::reports {

StudyFacts study_facts(const study::LoadedStudy& study) {
  StudyFacts facts{.folder = study.folder.string(),
                   .spec = study.spec,
                   .objectives = {},
                   .evaluations = static_cast<int>(study.designs.size()),
                   .log_complete = study.log_complete,
                   .counted_spacing = study::counted_spacing(study),
                   .spacings = {}};
  for (const designs::Objective& objective : study.spec.objectives) {
    facts.objectives.push_back(terms_of(study.spec, objective));
  }
  std::map<double, SpacingCount> counts;
  for (const records::EvaluationRecord& record : study.designs) {
    facts.failed += record.ok ? 0 : 1;
    facts.feasible += record.ok && record.feasible ? 1 : 0;
    facts.simulations += std::max(1, static_cast<int>(record.scenarios.size()));
    facts.cpu_time += record.cpu_time;
    SpacingCount& count = counts[record.spacing];
    count.spacing = record.spacing;
    ++count.designs;
    count.failed += record.ok ? 0 : 1;
    count.feasible += record.ok && record.feasible ? 1 : 0;
  }
  for (const auto& [spacing, count] : counts) facts.spacings.push_back(count);
  if (study.front) facts.events = study.front->events;
  return facts;
}

}  // namespace parapet::reports
