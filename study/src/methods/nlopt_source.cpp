#include "nlopt_source.hpp"

#include <utility>

#include "parapet/study/problem.hpp"

namespace parapet::study {

NloptSource::NloptSource(const StudyContext& context, Optimisation optimisation)
    : optimisation_(std::move(optimisation)),
      evaluator_(context, handover_),
      thread_([this] { optimise(); }) {}

NloptSource::~NloptSource() {
  stop();
}

void NloptSource::optimise() {
  try {
    result_ = optimisation_(evaluator_);
  } catch (...) {
    failure_ = std::current_exception();
  }
  handover_.end(failure_);
}

void NloptSource::stop() {
  handover_.stop();
  if (thread_.joinable()) thread_.join();
}

std::vector<Proposal> NloptSource::next() {
  std::vector<Proposal> batch = handover_.take();
  evaluator_.log_refused();
  if (!batch.empty()) {
    proposed_ += batch_;
    batch_ = batch.size();
  }
  return batch;
}

void NloptSource::answered(std::size_t number, const records::EvaluationRecord& record) {
  handover_.answer(number - proposed_, record);
}

optimizer::OptimizeResult NloptSource::finish() {
  stop();
  evaluator_.log_refused();
  if (failure_) std::rethrow_exception(failure_);
  return result_;
}

optimizer::OptimizeResult optimize_weighted_sum(const designs::StudySpec& study,
                                                BlockingEvaluator& evaluator) {
  optimizer::Problem problem = make_problem(study);
  const Scalarizer scalarizer = weighted_sum(study);
  problem.evaluate = [&](const std::vector<double>& x) {
    return evaluator.evaluate({x}, "search", scalarizer).front();
  };
  problem.evaluate_batch = [&](const std::vector<std::vector<double>>& xs) {
    return evaluator.evaluate(xs, "start", scalarizer);
  };
  optimizer::Options options = make_options(study);
  options.cancelled = [&] { return evaluator.stopped(); };
  options.on_refused = [&](const std::vector<double>& x) { evaluator.refused(x); };
  return optimizer::optimize(problem, options);
}

}  // namespace parapet::study
