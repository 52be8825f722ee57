#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <string_view>

#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/experiments.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::study {
namespace {

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// The member of /method that a sentence of the optimizer is about.
std::string blamed_member(const std::string& sentence) {
  if (sentence.find("exceed max_evaluations") != std::string::npos) return "max_evaluations";
  if (sentence.find("needs a local_algorithm") != std::string::npos) return "local_algorithm";
  constexpr std::array<std::string_view, 7> members{
      "max_evaluations", "max_time_s",      "relative_tolerance",   "initial_step",
      "start_count",     "local_algorithm", "feasibility_tolerance"};
  for (const std::string_view member : members) {
    if (sentence.starts_with(member)) return std::string(member);
  }
  if (sentence.starts_with("starting point")) return "starts";
  if (sentence.starts_with("Sobol'")) return "start_count";
  return "algorithm";
}

/// The sentence without "; allowed: ..." and that part.
designs::InputIssue issue_of(const std::string& sentence, const designs::StudySpec& study) {
  designs::InputIssue issue;
  const std::string member = blamed_member(sentence);
  issue.file = study.source_file;
  issue.pointer = "/method/" + member;
  if (study.resolved.contains("method") && study.resolved["method"].contains(member)) {
    const designs::Json& value = study.resolved["method"][member];
    if (!value.is_structured()) issue.value = value.dump();
  }
  const std::string mark = "; allowed: ";
  const std::size_t at = sentence.rfind(mark);
  issue.problem = sentence.substr(0, at);
  if (at != std::string::npos) issue.allowed = sentence.substr(at + mark.size());
  return issue;
}

}  // namespace

optimizer::Options make_options(const designs::StudySpec& study) {
  const designs::Method& method = study.method;
  optimizer::Options options;
  options.algorithm = method.algorithm;
  options.local_algorithm = method.local_algorithm;
  const std::string name = upper_case(method.algorithm);
  const bool takes_local =
      name.find("MLSL") != std::string::npos || name.find("AUGLAG") != std::string::npos;
  if (takes_local && options.local_algorithm.empty()) options.local_algorithm = "COBYLA";
  options.max_evaluations = method.max_evaluations;
  options.max_time_s = method.max_time_s;
  options.relative_tolerance = method.relative_tolerance;
  options.initial_step = method.initial_step;
  options.seed = method.seed;
  options.start_count = method.start_count;
  options.feasibility_tolerance = feasibility_tolerance;
  for (const designs::Design& start : method.starts) {
    std::vector<double> x;
    for (const designs::Variable& variable : study.variables) x.push_back(start.at(variable.name));
    options.starts.push_back(std::move(x));
  }
  return options;
}

namespace {

designs::InputIssue method_issue(const designs::StudySpec& study, const std::string& member,
                                 const std::string& value, const std::string& problem,
                                 const std::string& allowed) {
  return {.file = study.source_file,
          .pointer = "/method/" + member,
          .value = value,
          .problem = problem,
          .allowed = allowed};
}

std::vector<designs::InputIssue> search_issues(const designs::StudySpec& study) {
  try {
    bayesian::Search(make_search_problem(study).problem, make_search_options(study));
  } catch (const std::invalid_argument& error) {
    return {method_issue(study, "algorithm", designs::Json(study.method.algorithm).dump(),
                         error.what(), "a study that the algorithm can search")};
  }
  return {};
}

std::vector<designs::InputIssue> experiment_issues(const designs::StudySpec& study) {
  try {
    require_experiments_in_budget(study);
  } catch (const designs::InputError& error) {
    return error.issues();
  }
  return {};
}

std::vector<designs::InputIssue> nlopt_issues(const designs::StudySpec& study) {
  for (const designs::Variable& variable : study.variables) {
    if (variable.kind != designs::VariableKind::choice) continue;
    return {method_issue(study, "algorithm", designs::Json(study.method.algorithm).dump(),
                         "knows no choices, and " + variable.name + " is one",
                         "BAYESIAN, SOBOL, LATIN_HYPERCUBE, FULL_FACTORIAL or LIST")};
  }
  optimizer::Problem problem = make_problem(study);
  problem.evaluate = [](const std::vector<double>&) { return optimizer::Evaluation{}; };
  std::vector<designs::InputIssue> issues;
  for (const std::string& sentence : optimizer::problem_errors(problem, make_options(study))) {
    issues.push_back(issue_of(sentence, study));
  }
  return issues;
}

}  // namespace

std::vector<designs::InputIssue> method_issues(const designs::StudySpec& study) {
  switch (designs::search_kind(study)) {
    case designs::SearchKind::bayesian:
      return search_issues(study);
    case designs::SearchKind::experiments:
      return experiment_issues(study);
    case designs::SearchKind::scalarized:
    case designs::SearchKind::weighted_sum:
      break;
  }
  return nlopt_issues(study);
}

}  // namespace parapet::study
