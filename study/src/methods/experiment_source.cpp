#include "experiment_source.hpp"

#include <utility>

namespace parapet::study {

ExperimentSource::ExperimentSource(const designs::StudySpec& study, Experiments experiments)
    : spacing_(designs::finest_spacing(study)), experiments_(std::move(experiments)) {}

std::vector<Proposal> ExperimentSource::next() {
  if (next_ >= experiments_.designs.size()) return {};
  Proposal proposal;
  proposal.stage = next_ < experiments_.n_starts ? "start" : "sample";
  proposal.design = experiments_.designs[next_++];
  proposal.spacing = spacing_;
  return {std::move(proposal)};
}

}  // namespace parapet::study
