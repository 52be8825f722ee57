#include "bayesian_source.hpp"

#include <algorithm>

namespace parapet::study {

BayesianSource::BayesianSource(const StudyContext& context, const SearchProblem& problem,
                               bayesian::Search& search, AnswerOrder order, std::size_t lag)
    : context_(context),
      problem_(problem),
      search_(search),
      order_(order),
      lag_(std::max<std::size_t>(1, lag)),
      log_told_(context.folder.log().records().size(), false) {
  if (order_ != AnswerOrder::as_they_come) return;
  tell_log();
  unfinished_ = context_.folder.unfinished();
  std::reverse(unfinished_.begin(), unfinished_.end());
}

void BayesianSource::keep(const records::EvaluationRecord& record) {
  if (has_distribution(context_.study)) known_.push_back(record);
}

/// What is told so far says more of the statistics of each design.
void BayesianSource::revise() {
  if (known_.size() == revised_) return;
  revised_ = known_.size();
  revise_statistics(context_.study, problem_, known_, search_);
}

void BayesianSource::tell_record(const records::EvaluationRecord& record) {
  const auto level = level_of(problem_, record.spacing);
  const bool fits =
      level && designs::check_design(context_.study, record.design, "the log").empty();
  if (!fits) return;
  search_.tell_external(to_point(context_.study, record.design), *level,
                        observation(context_.study, problem_, record));
  keep(record);
}

void BayesianSource::tell_log() {
  for (const auto& record : context_.folder.log().records()) tell_record(record);
}

void BayesianSource::tell_log_before(const Proposal& proposal) {
  const auto& records = context_.folder.log().records();
  const auto* found = context_.folder.log().find(proposal.design, proposal.spacing);
  const auto place = found == nullptr ? log_told_.size()
                                      : std::min(log_told_.size(),
                                                 static_cast<std::size_t>(found - records.data()));
  for (std::size_t k = 0; k < place; ++k) {
    if (log_told_[k]) continue;
    log_told_[k] = true;
    tell_record(records[k]);
  }
  if (place < log_told_.size()) log_told_[place] = true;  // the answer to the question
}

bool BayesianSource::tell_next() {
  const auto found = answers_.find(told_);
  if (found == answers_.end()) return false;
  search_.tell(questions_[told_].value(), observation(context_.study, problem_, found->second));
  keep(found->second);
  answers_.erase(found);
  ++told_;
  return true;
}

bool BayesianSource::told_enough() {
  if (questions_.size() + 1 > lag_) {
    const std::size_t block = answers_at_once(lag_);
    needed_ = std::max(needed_, (questions_.size() + 1 - lag_) / block * block);
  }
  while (told_ < needed_) {
    if (!tell_next()) return false;
  }
  return true;
}

bool BayesianSource::within_budget() const {
  // The search does not know of the incomplete designs that are under way.
  const auto used = static_cast<std::size_t>(search_.evaluations()) + open_;
  return used < static_cast<std::size_t>(context_.study.method.max_evaluations);
}

std::optional<Proposal> BayesianSource::ask() {
  revise();
  const auto suggestion = search_.ask();
  if (!suggestion) return std::nullopt;
  Proposal proposal;
  proposal.stage = suggestion->stage;
  proposal.design = to_design(context_.study, problem_.problem.space, suggestion->x);
  proposal.spacing = problem_.spacings[static_cast<std::size_t>(suggestion->level)];
  if (order_ == AnswerOrder::by_question) {
    tell_log_before(proposal);
    const bool known = context_.folder.log().find(proposal.design, proposal.spacing) != nullptr;
    // The rest of the log has used the budget up; the question was put without knowing it.
    const auto used = static_cast<std::size_t>(search_.evaluations()) + questions_.size() - told_;
    if (!known && used >= static_cast<std::size_t>(context_.study.method.max_evaluations)) {
      return std::nullopt;
    }
  }
  questions_.emplace_back(suggestion->id);
  ++open_;
  return proposal;
}

std::optional<Proposal> BayesianSource::propose() {
  if (!unfinished_.empty()) {
    const records::UnfinishedDesign one = unfinished_.back();
    unfinished_.pop_back();
    resumed_.emplace(std::pair(one.design, one.spacing), questions_.size());
    questions_.emplace_back();
    ++open_;
    return Proposal{.stage = "search", .design = one.design, .spacing = one.spacing};
  }
  if (order_ == AnswerOrder::as_they_come) {
    return propose_as_they_come();
  }
  while (told_enough()) {
    if (auto proposal = ask()) return proposal;
    // Nothing sensible before another answer: exactly one more, whichever are there already.
    if (search_.stop_reason() != bayesian::StopReason::none || told_ == questions_.size()) break;
    needed_ = told_ + 1;
  }
  return std::nullopt;
}

/// The search does not know of the incomplete designs under way, and may well ask for one of them
/// again: the answer is then told once, as the answer to its question.
std::optional<Proposal> BayesianSource::propose_as_they_come() {
  while (open_ == 0 || within_budget()) {
    auto proposal = ask();
    if (!proposal) return std::nullopt;
    const auto found = resumed_.find(std::pair(proposal->design, proposal->spacing));
    if (found == resumed_.end()) return proposal;
    questions_[found->second] = questions_.back();
    questions_.pop_back();
    --open_;
    resumed_.erase(found);
  }
  return std::nullopt;
}

std::vector<Proposal> BayesianSource::next() {
  if (auto proposal = propose()) return {*std::move(proposal)};
  return {};
}

void BayesianSource::answered(std::size_t number, const records::EvaluationRecord& record) {
  --open_;
  std::erase_if(resumed_, [&](const auto& one) { return one.second == number; });
  if (order_ != AnswerOrder::as_they_come) {
    answers_.emplace(number, record);
  } else if (questions_[number]) {
    search_.tell(*questions_[number], observation(context_.study, problem_, record));
    keep(record);
  } else {
    tell_record(record);
  }
}

void BayesianSource::finish() {
  if (order_ == AnswerOrder::as_they_come) return revise();
  while (tell_next()) {
  }
  // A stop may have left a gap.
  for (const auto& [number, record] : answers_) {
    search_.tell(questions_[number].value(), observation(context_.study, problem_, record));
    keep(record);
  }
  answers_.clear();
  revise();
}

std::size_t open_questions(int jobs, std::size_t events) {
  if (jobs <= 1) return 1;
  const auto others = static_cast<std::size_t>(jobs - 1);
  constexpr std::size_t own = 1, spare = 1;
  return own + (others + events - 1) / std::max<std::size_t>(1, events) + spare;
}

std::size_t answers_at_once(std::size_t lag) {
  constexpr std::size_t share = 16, most = 16;
  return std::clamp<std::size_t>(lag / share, 1, most);
}

}  // namespace parapet::study
