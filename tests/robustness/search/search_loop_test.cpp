// The asynchronous search: resumable, repeatable, within its budgets.
#include <algorithm>
#include <cmath>

#include "fake_study.hpp"
#include "parapet/records/evaluation_log.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using study::StudyState;

class SearchLoop : public FakeStudyTest {};

/// Simulations that were asked for again although they had ended.
int repetitions(const FakeSimulator& first, const FakeSimulator& second) {
  int count = 0;
  const auto before = first.counts();
  for (const auto& [what, times] : second.counts()) {
    const auto found = before.find(what);
    count += times - 1 + (found == before.end() ? 0 : found->second);
  }
  return count;
}

TEST_F(SearchLoop, UsesItsBudgetAndFindsTheFront) {
  const FakeSimulator simulator;
  const auto summary = run(parsed(fake_study()), "out", simulator);
  EXPECT_EQ(summary.state, StudyState::done) << summary.message;
  EXPECT_EQ(summary.termination, "budget");
  EXPECT_EQ(summary.evaluations, 14);
  EXPECT_EQ(simulator.ended(), 14);
  ASSERT_GE(summary.pareto.size(), 3U);
  // On the front sqrt(f1) + sqrt(f2) is 1. Fourteen designs of two variables reach it: measured
  // 1.000 for the best of them, limit 1.05 for another version of the search.
  double nearest = 10.0;
  for (const auto& record : summary.pareto) {
    nearest = std::min(
        nearest, std::sqrt(*record.objectives[0].value) + std::sqrt(*record.objectives[1].value));
  }
  EXPECT_LT(nearest, 1.05);
}

TEST_F(SearchLoop, StoppedAnywhereItResumesToTheSameLog) {
  const auto study = parsed(fake_study());
  run(study, "calm", FakeSimulator());
  for (const int stop : {0, 1, 5, 9, 13}) {
    const std::string out = "out" + std::to_string(stop);
    const FakeSimulator disturbed({.delays = false, .fails = {}, .cancel_after = stop});
    EXPECT_EQ(run(study, out, disturbed).state, StudyState::interrupted);
    EXPECT_EQ(records(out).size(), static_cast<std::size_t>(stop));
    const FakeSimulator again;
    const auto summary = run(study, out, again);
    EXPECT_EQ(summary.state, StudyState::done);
    EXPECT_EQ(records(out), records("calm")) << "stopped after " << stop;
    EXPECT_EQ(repetitions(disturbed, again), 0);
    EXPECT_EQ(json(out, "pareto.json"), json("calm", "pareto.json"));
    EXPECT_EQ(json(out, "surrogates.json"), json("calm", "surrogates.json"));
  }
}

TEST_F(SearchLoop, RepeatableSearchDoesNotDependOnTheSpeedOfSimulations) {
  const auto study = parsed(fake_study());
  EXPECT_TRUE(study.method.repeatable) << "by default";
  run(study, "calm", FakeSimulator(), 3);
  const std::string log = file_text(folder / "calm/evaluations.jsonl");
  for (const char* out : {"first", "second"}) {
    run(study, out, FakeSimulator({.delays = true, .fails = {}, .cancel_after = -1}), 3);
    EXPECT_EQ(records(out), records("calm"));
    EXPECT_EQ(file_text(folder / out / "evaluations.jsonl"), log) << "the order too";
  }
  const FakeSimulator disturbed({.delays = true, .fails = {}, .cancel_after = 8});
  run(study, "stopped", disturbed, 3);
  const FakeSimulator again({.delays = true, .fails = {}, .cancel_after = -1});
  run(study, "stopped", again, 3);
  EXPECT_EQ(records("stopped"), records("calm"));
  EXPECT_EQ(repetitions(disturbed, again), 0);
  EXPECT_EQ(file_text(folder / "stopped/evaluations.jsonl"), log);
  EXPECT_EQ(files("stopped"), files("calm")) << "what waited for the log is gone";
}

// Whatever the search: a design that ends early waits on disk for those proposed before it.
TEST_F(SearchLoop, LogHasTheOrderOfTheProposalsForEverySearch) {
  for (const char* algorithm : {"SOBOL", "LATIN_HYPERCUBE", "FULL_FACTORIAL", "COBYLA"}) {
    Json json = fake_study();
    json["method"]["algorithm"] = algorithm;
    json["method"]["start_count"] = 6;
    const auto study = parsed(json);
    const std::string calm = std::string(algorithm) + "-calm", out = algorithm;
    run(study, calm, FakeSimulator(), 1);
    const FakeSimulator disturbed({.delays = true, .fails = {}, .cancel_after = 4});
    run(study, out, disturbed, 4);
    const FakeSimulator again({.delays = true, .fails = {}, .cancel_after = -1});
    run(study, out, again, 4);
    EXPECT_EQ(repetitions(disturbed, again), 0) << algorithm;
    EXPECT_EQ(file_text(folder / out / "evaluations.jsonl"),
              file_text(folder / calm / "evaluations.jsonl"))
        << algorithm;
  }
}

// With many open questions answers are told in blocks (of three with 50 jobs), so that the
// surrogates change less often; which answers a question knows still hangs on nothing else.
TEST_F(SearchLoop, ManyJobsAreRepeatableToo) {
  Json json = fake_study();
  json["method"]["max_evaluations"] = 80;
  const auto study = parsed(json);
  constexpr int jobs = 50;
  run(study, "calm", FakeSimulator(), jobs);
  EXPECT_EQ(records("calm").size(), 80U);
  const FakeSimulator disturbed({.delays = true, .fails = {}, .cancel_after = 65});
  run(study, "stopped", disturbed, jobs);
  const FakeSimulator again({.delays = true, .fails = {}, .cancel_after = -1});
  run(study, "stopped", again, 3);
  EXPECT_EQ(repetitions(disturbed, again), 0);
  EXPECT_EQ(file_text(folder / "stopped/evaluations.jsonl"),
            file_text(folder / "calm/evaluations.jsonl"));
}

// A budget that the clock does not touch: the same designs, stopped and resumed or not.
TEST_F(SearchLoop, BudgetOfFinestRunsEndsEverySearch) {
  for (const char* algorithm : {"BAYESIAN", "SOBOL", "COBYLA"}) {
    Json json = fake_study();
    json["method"]["algorithm"] = algorithm;
    json["method"]["max_finest_runs"] = 6;
    const auto study = parsed(json);
    const std::string calm = std::string(algorithm) + "-calm", out = algorithm;
    const auto summary = run(study, calm, FakeSimulator(), 3);
    EXPECT_EQ(summary.termination, "budget") << algorithm << ": " << summary.message;
    EXPECT_NE(summary.message.find("6 finest runs"), std::string::npos) << summary.message;
    EXPECT_EQ(summary.evaluations, 6) << algorithm;
    const FakeSimulator disturbed({.delays = true, .fails = {}, .cancel_after = 3});
    run(study, out, disturbed, 3);
    EXPECT_EQ(run(study, out, FakeSimulator(), 3).evaluations, 6) << algorithm;
    EXPECT_EQ(records(out), records(calm)) << algorithm;
    json["method"]["max_finest_runs"] = 8;
    EXPECT_EQ(run(parsed(json), out, FakeSimulator(), 3).evaluations, 8) << "goes on";
  }
}

// Every design takes three simulations, one for each event.
TEST_F(SearchLoop, BudgetOfFinestRunsCountsEvents) {
  Json json = fake_study_with_scenarios();
  json["method"]["max_finest_runs"] = 12;
  const FakeSimulator simulator;
  EXPECT_EQ(run(parsed(json), "out", simulator, 2).evaluations, 4);
  EXPECT_EQ(simulator.ended(), 12);
  json["method"]["max_finest_runs"] = 2;
  try {
    parsed(json);
    FAIL() << "accepted";
  } catch (const designs::InputError& error) {
    EXPECT_EQ(error.issues().front().pointer, "/method/max_finest_runs");
    EXPECT_NE(error.issues().front().allowed.find("at least 3"), std::string::npos);
  }
}

TEST_F(SearchLoop, SeveralJobsResumeFromTheLogAndKeepTheBudget) {
  Json json = fake_study();
  json["method"]["repeatable"] = false;
  const auto study = parsed(json);
  const FakeSimulator disturbed({.delays = true, .fails = {}, .cancel_after = 7});
  EXPECT_EQ(run(study, "out", disturbed, 3).state, StudyState::interrupted);
  const auto before = records("out");
  EXPECT_EQ(before.size(), 7U);
  const FakeSimulator again({.delays = true, .fails = {}, .cancel_after = -1});
  const auto summary = run(study, "out", again, 3);
  EXPECT_EQ(summary.evaluations, 14);
  EXPECT_EQ(again.ended(), 7) << "what was logged counts";
  EXPECT_EQ(repetitions(disturbed, again), 0);
  const auto after = records("out");
  for (const auto& [id, record] : before) EXPECT_EQ(after.at(id), record);
}

TEST_F(SearchLoop, LargerBudgetGoesOn) {
  Json json = fake_study();
  run(parsed(json), "calm", FakeSimulator());
  json["method"]["max_evaluations"] = 9;
  run(parsed(json), "out", FakeSimulator());
  EXPECT_EQ(records("out").size(), 9U);
  const FakeSimulator more;
  run(parsed(fake_study()), "out", more);
  EXPECT_EQ(more.ended(), 5);
  EXPECT_EQ(records("out").size(), 14U);
}

// The questions of a repeatable search hang on the number of jobs that it was begun with: moved to
// a machine with more or fewer cores it goes on with the same ones.
TEST_F(SearchLoop, RepeatableSearchResumesWithOtherJobs) {
  Json json = fake_study();
  json["method"]["repeatable"] = true;
  const auto study = parsed(json);
  run(study, "calm", FakeSimulator(), 4);
  for (const int jobs : {1, 2, 6}) {
    const std::string out = "moved-" + std::to_string(jobs);
    const FakeSimulator disturbed({.delays = true, .fails = {}, .cancel_after = 12});
    run(study, out, disturbed, 4);
    const FakeSimulator again;
    run(study, out, again, jobs);
    EXPECT_EQ(records(out), records("calm")) << jobs;
    EXPECT_EQ(repetitions(disturbed, again), 0) << jobs;
    const FakeSimulator idle;
    run(study, out, idle, jobs);
    EXPECT_EQ(idle.ended(), 0) << "a finished study simulates nothing";
  }
}

// A larger budget continues: the initial designs stay those of the first budget.
TEST_F(SearchLoop, LargerBudgetRepeatsNothing) {
  for (const bool repeatable : {false, true}) {
    Json json = fake_study();
    json["method"]["repeatable"] = repeatable;
    json["method"]["max_evaluations"] = 9;
    const std::string out = repeatable ? "larger-repeatable" : "larger";
    const FakeSimulator first, second;
    run(parsed(json), out, first);
    EXPECT_EQ(first.ended(), 9);
    json["method"]["max_evaluations"] = 15;
    run(parsed(json), out, second);
    EXPECT_EQ(second.ended(), 6);
    EXPECT_EQ(repetitions(first, second), 0);
    EXPECT_EQ(records(out).size(), 15U);
  }
}

// What several jobs have finished, one job finds finished.
TEST_F(SearchLoop, FinishedStudyIsFinishedForAnyJobs) {
  const auto study = parsed(fake_study());
  run(study, "study", FakeSimulator(), 4);
  const FakeSimulator idle;
  const auto summary = run(study, "study", idle, 1);
  EXPECT_EQ(idle.ended(), 0);
  EXPECT_EQ(summary.state, study::StudyState::done);
}

TEST_F(SearchLoop, EventsThatEndedBeforeAStopAreNotSimulatedAgain) {
  const auto study = parsed(fake_study_with_scenarios());
  run(study, "calm", FakeSimulator());
  for (const int jobs : {1, 2}) {
    const std::string out = "out" + std::to_string(jobs);
    // Four designs have ended then, and two of three events of the fifth.
    const FakeSimulator disturbed({.delays = false, .fails = {}, .cancel_after = 14});
    run(study, out, disturbed, jobs);
    EXPECT_EQ(disturbed.ended(), 14);
    const FakeSimulator again;
    run(study, out, again, jobs);
    EXPECT_EQ(again.ended(), 3 * 14 - 14);
    EXPECT_EQ(repetitions(disturbed, again), 0);
    EXPECT_EQ(files(out), 14 * 4) << "one file for each event and one for each design";
    if (jobs == 1) {
      EXPECT_EQ(records(out), records("calm"));
    }
  }
}

TEST_F(SearchLoop, BudgetOfProcessorTimeEndsTheSearch) {
  Json json = fake_study();
  json["method"]["max_cpu_time_s"] = 6.5;  // a simulation takes 1 s
  const auto study = parsed(json);
  for (const char* algorithm : {"BAYESIAN", "SOBOL", "COBYLA"}) {
    Json with = json;
    with["method"]["algorithm"] = algorithm;
    const auto summary = run(parsed(with), algorithm, FakeSimulator());
    EXPECT_EQ(summary.termination, "cpu_time_limit") << algorithm << ": " << summary.message;
    EXPECT_EQ(summary.state, StudyState::done);
    EXPECT_EQ(summary.evaluations, 7) << algorithm;
    EXPECT_EQ(run(parsed(with), algorithm, FakeSimulator()).evaluations, 7) << "still used up";
  }
}

TEST_F(SearchLoop, BudgetOfTimeEndsTheSearch) {
  Json json = fake_study();
  json["method"]["max_time_s"] = 1e-6;
  const auto summary = run(parsed(json), "out", FakeSimulator(), 2);
  EXPECT_EQ(summary.termination, "time_limit");
  EXPECT_EQ(summary.evaluations, 0);
}

TEST_F(SearchLoop, DesignsFromOutsideAreToldBeforeTheSearchGoesOn) {
  const auto study = parsed(fake_study());
  Json json = fake_study();
  json["method"]["algorithm"] = "LIST";
  json["method"]["starts"] = Json::parse(R"([
    {"deflector_angle_deg": 12, "upstream_height_m": 0.041},
    {"deflector_angle_deg": 50, "upstream_height_m": 0.042}])");
  run(parsed(json), "list", FakeSimulator());
  for (const int jobs : {1, 3}) {
    const std::string out = "out" + std::to_string(jobs);
    run(study, out, FakeSimulator({.delays = false, .fails = {}, .cancel_after = 0}), jobs);
    std::filesystem::copy_file(folder / "list/evaluations.jsonl",
                               folder / (out + "/evaluations.jsonl"),
                               std::filesystem::copy_options::overwrite_existing);
    const FakeSimulator simulator({.delays = false, .fails = {}, .cancel_after = 6});
    run(study, out, simulator, jobs);
    const FakeSimulator again;
    run(study, out, again, jobs);
    EXPECT_EQ(records(out).size(), 14U) << "the two from outside count";
    EXPECT_EQ(repetitions(simulator, again), 0);
  }
}

}  // namespace
}  // namespace parapet::test
