#include "rank_draws.hpp"

#include <algorithm>

#include "parapet/study/study_surrogates.hpp"

namespace parapet::study {
namespace {

constexpr int draw_count = 512;  // a share of a half is known to 0.02

}  // namespace

std::vector<std::vector<std::vector<double>>> objective_draws(
    const LoadedStudy& study, const std::vector<Candidate>& candidates) {
  if (study.surrogates == nullptr || candidates.empty()) return {};
  std::vector<const designs::Design*> designs;
  for (const Candidate& one : candidates) designs.push_back(&one.design->design);
  std::vector<std::vector<double>> expected;
  for (const Candidate& one : candidates) expected.push_back(one.expected);
  std::vector<std::vector<std::vector<double>>> draws(draw_count, expected);
  bool any = false;
  for (std::size_t j = 0; j < study.spec.objectives.size(); ++j) {
    const designs::Objective& objective = study.spec.objectives[j];
    if (is_exact(objective)) continue;
    const Eigen::MatrixXd values =
        study.surrogates->draws({GoalPlace::Kind::objective, j}, designs,
                                candidates.front().design->spacing, draw_count, j + 1);
    if (values.cols() == 0) continue;
    any = true;
    const double sign = objective.goal == designs::Goal::maximize ? -1.0 : 1.0;
    for (std::size_t row = 0; row < draws.size(); ++row) {
      for (std::size_t k = 0; k < designs.size(); ++k) {
        draws[row][k][j] =
            sign * values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
      }
    }
  }
  if (!any) draws.clear();
  return draws;
}

void count_draws(const std::vector<std::vector<std::vector<double>>>& draws, const Scores& scores,
                 std::vector<Candidate>& candidates) {
  if (draws.empty() || candidates.empty()) return;
  std::vector<int> first(candidates.size(), 0), better(candidates.size(), 0);
  for (const auto& values : draws) {
    const std::vector<double> score = scores(values);
    ++first[static_cast<std::size_t>(std::ranges::min_element(score) - score.begin())];
    for (std::size_t k = 1; k < score.size(); ++k) better[k] += score[k] < score[0] ? 1 : 0;
  }
  const auto all = static_cast<double>(draws.size());
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    candidates[k].share = first[k] / all;
    if (k > 0) candidates[k].beats = better[k] / all;
  }
}

}  // namespace parapet::study
