#include "parapet/study/study_search.hpp"

#include <stdexcept>
#include <utility>

#include "parapet/study/event_model.hpp"
#include "parapet/study/problem.hpp"

namespace parapet::study {
namespace {

designs::StudySpec searchable(designs::StudySpec study) {
  if (designs::search_kind(study) != designs::SearchKind::bayesian) {
    throw designs::InputError({{.file = study.source_file,
                                .pointer = "/method/algorithm",
                                .value = designs::Json(study.method.algorithm).dump(),
                                .problem = "cannot be asked and told design by design",
                                .allowed = "BAYESIAN"}});
  }
  if (auto issues = method_issues(study); !issues.empty()) {
    throw designs::InputError(std::move(issues));
  }
  return study;
}

}  // namespace

StudySearch::StudySearch(designs::StudySpec study)
    : study_(std::make_unique<const designs::StudySpec>(searchable(std::move(study)))),
      problem_(make_search_problem(*study_)),
      search_(problem_.problem, make_search_options(*study_)) {}

std::optional<AskedDesign> StudySearch::ask() {
  if (has_distribution(*study_) && records_.size() != revised_) {
    revised_ = records_.size();
    revise_statistics(*study_, problem_, records_, search_);
  }
  const auto suggestion = search_.ask();
  if (!suggestion) return std::nullopt;
  AskedDesign asked{.id = suggestion->id,
                    .stage = suggestion->stage,
                    .design = to_design(*study_, problem_.problem.space, suggestion->x),
                    .spacing = problem_.spacings[static_cast<std::size_t>(suggestion->level)]};
  asked_[asked.id] = asked;
  return asked;
}

void StudySearch::keep(int id, records::EvaluationRecord record) {
  record.id = records::evaluation_id(id + 1);
  records_.push_back(std::move(record));
}

void StudySearch::tell(int id, records::EvaluationRecord record) {
  const auto found = asked_.find(id);
  if (found == asked_.end()) {
    throw std::invalid_argument("no design of the number " + std::to_string(id) +
                                " waits for an answer");
  }
  if (record.design != found->second.design || record.spacing != found->second.spacing) {
    throw std::invalid_argument(
        "the record is of another design, or at another particle spacing, "
        "than what was asked");
  }
  search_.tell(id, observation(*study_, problem_, record));
  record.stage = found->second.stage;
  asked_.erase(found);
  keep(id, std::move(record));
}

void StudySearch::tell_other(records::EvaluationRecord record) {
  const auto level = level_of(problem_, record.spacing);
  if (!level) throw std::invalid_argument("the study has no such particle spacing");
  if (auto issues = designs::check_design(*study_, record.design, "the record"); !issues.empty()) {
    throw std::invalid_argument(designs::to_string(issues.front()));
  }
  const int id = search_.tell_external(to_point(*study_, record.design), *level,
                                       observation(*study_, problem_, record));
  keep(id, std::move(record));
}

std::string StudySearch::stop_reason() const {
  const bayesian::StopReason reason = search_.stop_reason();
  return reason == bayesian::StopReason::none ? "" : bayesian::to_string(reason);
}

Front StudySearch::front() const {
  return make_front(*study_, records_, search_.reference());
}

designs::Json StudySearch::front_json() const {
  return pareto_json(*study_, front(), &problem_, &search_);
}

}  // namespace parapet::study
