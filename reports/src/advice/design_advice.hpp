/// One design, as advice tells of it.
#pragma once

#include "parapet/records/evaluation_log.hpp"
#include "parapet/reports/design_report.hpp"
#include "parapet/study/pick.hpp"

namespace parapet::reports {

ObjectiveTerms terms_of(const designs::StudySpec& study, const designs::Objective& objective);

/// A statistic over the scenarios in words; empty for a study of one event.
/// @param of_design it is of a formula of the design alone
std::string statistic_words(const designs::StudySpec& study, bool of_design,
                            designs::Statistic statistic, double quantile);

WrittenDesign written_design(const designs::StudySpec& study, const designs::Design& design);

DesignReport design_report(const designs::StudySpec& study,
                           const records::EvaluationRecord& record);

/// [n_objectives]
std::vector<ObjectiveEstimate> estimates_of(const designs::StudySpec& study,
                                            const study::Candidate& candidate);

/// 100 part / |whole|; empty without both.
std::optional<double> percent(const std::optional<double>& part,
                              const std::optional<double>& whole);

}  // namespace parapet::reports
