/// A design of experiments as a source of designs.
#pragma once

#include "design_source.hpp"
#include "parapet/study/experiments.hpp"

namespace parapet::study {

/// Proposes a list of designs, in order, at the study's finest spacing.
class ExperimentSource : public DesignSource {
 public:
  ExperimentSource(const designs::StudySpec& study, Experiments experiments);

  std::vector<Proposal> next() override;
  bool is_quick() const override { return true; }
  void answered(std::size_t, const records::EvaluationRecord&) override {}

 private:
  double spacing_;
  Experiments experiments_;
  std::size_t next_ = 0;
};

}  // namespace parapet::study
