// parapet optimize with every NLopt algorithm, on particles of 20 mm.
#include <gtest/gtest.h>

#include <set>

#include "parapet/optimizer/optimize.hpp"
#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;

/// Algorithms that need another one around which they work.
bool needs_local(const std::string& name) {
  return name == "MLSL" || name == "MLSL_LDS" || name == "AUGLAG";
}

class NloptAlgorithm : public ::testing::TestWithParam<std::string> {};

TEST_P(NloptAlgorithm, SearchesTheTinyCase) {
  constexpr int budget = 40;  // the evolution strategies start with 20
  Json study = tiny_study();
  study["name"] = "nlopt";
  study["method"]["algorithm"] = GetParam();
  study["method"]["max_evaluations"] = budget;
  if (needs_local(GetParam())) study["method"]["local_algorithm"] = "BOBYQA";
  const TemporaryFolder folder;
  folder.write("study.json", study.dump());
  const Outcome outcome =
      run_program(folder.path(), {"optimize", "study.json", "--jobs", "1", "--out", "out"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json summary = Json::parse(file_text(folder / "out/summary.json"));
  EXPECT_EQ(summary["state"], "done");
  // What is best must be a design that was simulated, that meets the limits, and no worse than the
  // best of the four starting ones.
  ASSERT_TRUE(summary["best"].is_object()) << summary.dump();
  EXPECT_TRUE(summary["best"]["feasible"].get<bool>());
  const double best = summary["best"]["objective_scalar"];
  if (summary["starting_best"].is_object()) {
    EXPECT_LE(best, summary["starting_best"]["objective_scalar"].get<double>());
  }
  int simulated = 0, of_the_algorithm = 0;
  bool found = false;
  const std::string text = file_text(folder / "out/evaluations.jsonl");
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const Json line = Json::parse(text.substr(begin, end - begin));
    begin = end + 1;
    if (line["status"] == "refused") continue;
    ++simulated;
    of_the_algorithm += line["stage"] == "search" ? 1 : 0;
    found = found || (line["feasible"].get<bool>() && line["objective_scalar"] == best);
  }
  EXPECT_LE(simulated, budget);
  EXPECT_GT(of_the_algorithm, 0);
  EXPECT_TRUE(found);
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const optimizer::AlgorithmInfo& info : optimizer::algorithms()) result.push_back(info.name);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Every, NloptAlgorithm, ::testing::ValuesIn(names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace parapet::test
