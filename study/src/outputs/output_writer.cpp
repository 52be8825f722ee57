#include "output_writer.hpp"

#include "parapet/study/event_model.hpp"

namespace parapet::study {
namespace {

using Clock = std::chrono::steady_clock;
using records::EvaluationRecord;

/// Lower objective first; equal ones by their id, so that the order in the log does not matter.
bool better(const EvaluationRecord& a, const EvaluationRecord& b) {
  if (*a.objective_scalar != *b.objective_scalar) return *a.objective_scalar < *b.objective_scalar;
  return a.id < b.id;
}

/// Among the feasible designs at the finest spacing.
std::optional<EvaluationRecord> best_of(const designs::StudySpec& study,
                                        const std::vector<EvaluationRecord>& records,
                                        bool only_starts) {
  const double spacing = designs::finest_spacing(study);
  const EvaluationRecord* best = nullptr;
  for (const EvaluationRecord& record : records) {
    if (!record.feasible || !record.objective_scalar || record.spacing != spacing) continue;
    if (only_starts && record.stage != "start") continue;
    if (best == nullptr || better(record, *best)) best = &record;
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

constexpr std::size_t write_interval = 10;  // records
constexpr std::chrono::milliseconds least_between_summaries{250};

}  // namespace

OutputWriter::OutputWriter(const designs::StudySpec& study, const records::StudyFolder& folder,
                           const Hooks& hooks)
    : study_(study), folder_(folder), hooks_(hooks), at_begin_(folder.log().records().size()) {}

void OutputWriter::attach(const SearchProblem& problem, const bayesian::Search& search) {
  problem_ = &problem;
  search_ = &search;
  reference_ = search.reference();
}

void OutputWriter::detach() {
  problem_ = nullptr;
  search_ = nullptr;
}

Front OutputWriter::front(bool with_history) const {
  return make_front(study_, folder_.log().records(), reference_, with_history);
}

bool OutputWriter::due() const {
  return folder_.log().records().size() >= written_at_ + write_interval;
}

void OutputWriter::record_added() {
  const Front now = front(false);
  // Answers of many workers come faster than anybody reads.
  const Clock::time_point time = Clock::now();
  if (time - summary_at_ >= least_between_summaries) {
    folder_.write("summary.json", to_json(complete({}, now), study_));
    summary_at_ = Clock::now();
  }
  if (hooks_.on_front) hooks_.on_front(static_cast<int>(now.designs.size()), now.hypervolume);
  if (search_ == nullptr && due()) write_outputs(front(true));
}

void OutputWriter::search_told() {
  reference_ = search_->reference();
  if (due()) write_outputs(front(true));
}

void OutputWriter::write_outputs(const Front& front, const EventModel* events) {
  written_at_ = folder_.log().records().size();
  folder_.write("pareto.json", pareto_json(study_, front, problem_, search_, events));
  if (search_ == nullptr) return;
  folder_.write("surrogates.json", surrogates_json(study_, *problem_, *search_));
  for (const std::string& sentence : surrogate_warnings(*problem_, *search_)) {
    const std::string without_figures = sentence.substr(0, sentence.find('('));
    if (warned_.insert(without_figures).second && hooks_.on_message) hooks_.on_message(sentence);
  }
}

StudySummary OutputWriter::complete(StudySummary summary, const Front& front) const {
  const auto& records = folder_.log().records();
  summary.evaluations = static_cast<int>(records.size());
  summary.simulated = static_cast<int>(records.size() - at_begin_);
  summary.best = best_of(study_, records, false);
  summary.starting_best = best_of(study_, records, true);
  summary.pareto = front.designs;
  summary.hypervolume = front.hypervolume;
  summary.elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
  return summary;
}

StudySummary OutputWriter::end(StudySummary summary) {
  if (search_ != nullptr) {
    reference_ = search_->reference();
    summary.optimizer_time = search_->own_seconds();
  }
  const Front last = front(true);
  if (search_ != nullptr && has_distribution(study_)) {
    const EventModel events(study_, folder_.log().records());
    write_outputs(last, &events);
  } else {
    write_outputs(last);
  }
  summary = complete(std::move(summary), last);
  folder_.write("summary.json", to_json(summary, study_));
  return summary;
}

}  // namespace parapet::study
