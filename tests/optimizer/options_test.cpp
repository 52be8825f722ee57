/// What optimize() refuses, in words; and how algorithms may be spelled.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <stdexcept>

#include "parapet/optimizer/optimize.hpp"
#include "problem_zoo.hpp"

namespace parapet::optimizer {
namespace {

std::string all(const std::vector<std::string>& errors) {
  std::string text;
  for (const auto& error : errors) text += error + "\n";
  return text;
}

struct Wrong {
  std::string what;
  std::function<void(Options&)> change;
  int n_variables;
  std::vector<std::string> words;  ///< all of them stand in the one error
};

// What CTest shows of a case.
void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.what;
}

class WrongOptions : public testing::TestWithParam<Wrong> {};

TEST_P(WrongOptions, GiveOneErrorThatNamesValueAndFix) {
  Options options;
  GetParam().change(options);
  const auto errors = option_errors(options, GetParam().n_variables, 1);
  ASSERT_EQ(errors.size(), 1U) << all(errors);
  for (const std::string& word : GetParam().words) {
    EXPECT_NE(errors[0].find(word), std::string::npos) << errors[0] << " lacks " << word;
  }
}

const std::vector<Wrong> wrong_options = {
    {"UnknownName",
     [](Options& o) { o.algorithm = "GENETIC"; },
     3,
     {"unknown algorithm \"GENETIC\"", "COBYLA", "MLSL_LDS"}},
    {"Misspelled", [](Options& o) { o.algorithm = "cobila"; }, 3, {"did you mean COBYLA?"}},
    {"NeedsGradients",
     [](Options& o) { o.algorithm = "SLSQP"; },
     3,
     {"SLSQP", "gradients", "use COBYLA"}},
    {"NeedsGradientsWithPrefix",
     [](Options& o) { o.algorithm = "NLOPT_LD_LBFGS"; },
     3,
     {"LBFGS", "gradients", "use BOBYQA"}},
    {"GradientMlsl", [](Options& o) { o.algorithm = "GD_MLSL"; }, 3, {"gradients", "MLSL_LDS"}},
    {"Stogo", [](Options& o) { o.algorithm = "gd-stogo"; }, 3, {"gradients", "DIRECT_L"}},
    {"NewuoaWithoutBounds",
     [](Options& o) { o.algorithm = "NEWUOA"; },
     3,
     {"bounds", "NEWUOA_BOUND"}},
    {"LocalMissing",
     [](Options& o) { o.algorithm = "MLSL"; },
     3,
     {"MLSL needs a local_algorithm", "BOBYQA"}},
    {"LocalIsGlobal",
     [](Options& o) {
       o.algorithm = "AUGLAG";
       o.local_algorithm = "ISRES";
     },
     3,
     {"ISRES", "not a local algorithm", "SBPLX"}},
    {"LocalUnknown",
     [](Options& o) {
       o.algorithm = "MLSL";
       o.local_algorithm = "BOBYQUA";
     },
     3,
     {"local_algorithm", "did you mean BOBYQA?"}},
    {"LocalNotWanted",
     [](Options& o) { o.local_algorithm = "BOBYQA"; },
     3,
     {"COBYLA takes none", "MLSL"}},
    {"OneVariable",
     [](Options& o) { o.algorithm = "BOBYQA"; },
     1,
     {"BOBYQA needs at least 2 variables", "has 1", "COBYLA"}},
    {"TooManyForAgs",
     [](Options& o) { o.algorithm = "AGS"; },
     6,
     {"AGS works up to 5", "has 6", "ISRES"}},
    {"StartTooShort",
     [](Options& o) {
       o.starts = {{1.0, 2.0}};
     },
     3,
     {"starting point 0 has 2 values", "3 variables"}},
    {"TooManyStarts",
     [](Options& o) { o.start_count = 41; },
     3,
     {"41 starting points exceed max_evaluations 40"}},
    {"BudgetTooSmallForCobyla",
     [](Options& o) { o.max_evaluations = 4; },
     3,
     {"max_evaluations 4 is too small", "COBYLA needs at least 5"}},
    {"BudgetTooSmallAfterStarts",
     [](Options& o) {
       o.max_evaluations = 12;
       o.algorithm = "BOBYQA";
       o.start_count = 6;
     },
     3,
     {"too small", "BOBYQA needs at least 8", "makes 13"}},
    {"NoBudget", [](Options& o) { o.max_evaluations = 0; }, 3, {"max_evaluations is 0", ">= 1"}},
    {"NegativeTime", [](Options& o) { o.max_time_s = -1.0; }, 3, {"max_time_s is -1"}},
    {"Tolerance",
     [](Options& o) { o.relative_tolerance = 0.0; },
     3,
     {"relative_tolerance is 0", "above 0"}},
    {"StepTooLong", [](Options& o) { o.initial_step = 0.7; }, 3, {"initial_step is 0.7", "0.5"}},
    {"StepBelowTolerance",
     [](Options& o) { o.relative_tolerance = 0.3; },
     3,
     {"relative_tolerance 0.3", "initial_step 0.25"}},
    {"NegativeStarts", [](Options& o) { o.start_count = -1; }, 3, {"start_count is -1"}},
    {"FeasibilityTolerance",
     [](Options& o) { o.feasibility_tolerance = std::nan(""); },
     3,
     {"feasibility_tolerance is nan"}},
    {"TooManyForSobol",
     [](Options& o) { o.max_evaluations = 400; },
     22,
     {"Sobol'", "up to 21", "has 22"}},
};

INSTANTIATE_TEST_SUITE_P(Options, WrongOptions, testing::ValuesIn(wrong_options),
                         [](const auto& instance) { return instance.param.what; });

TEST(Options, AllErrorsAreToldAtOnce) {
  Options options;
  options.algorithm = "MMA";
  options.initial_step = 2.0;
  options.starts = {{1.0}};
  EXPECT_EQ(option_errors(options, 2, 0).size(), 3U);
}

TEST(Options, NamesAreReadInEverySpelling) {
  for (const std::string name :
       {"cobyla", "LN_COBYLA", "NLOPT_LN_COBYLA", "ln-cobyla", "DIRECT-L", "gn_direct_l", "CRS2",
        "crs2-lm", "Nelder-Mead", "sbplx", "GN_ORIG_DIRECT_L", "direct-l-rand", "ESCH", "ags"}) {
    Options options;
    options.algorithm = name;
    EXPECT_EQ(all(option_errors(options, 3, 1)), "") << name;
  }
  Options options;
  options.algorithm = "G_MLSL_LDS";
  options.local_algorithm = "ln-bobyqa";
  EXPECT_EQ(all(option_errors(options, 3, 1)), "");
}

TEST(Options, TheTableSaysWhichAlgorithmsTakeConstraints) {
  std::vector<std::string> names;
  for (const AlgorithmInfo& info : algorithms()) {
    if (info.inequality_constraints) names.push_back(info.name);
    EXPECT_FALSE(info.note.empty()) << info.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"COBYLA", "ORIG_DIRECT", "ORIG_DIRECT_L", "ISRES",
                                             "AGS", "AUGLAG"}));
}

TEST(Problems, UnusableOnesAreRefusedInWords) {
  const auto message = [](const Problem& problem, const Options& options) -> std::string {
    try {
      optimize(problem, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing";
  };
  Options options;
  const Problem good = zoo::sphere(2).problem;
  const auto expect = [](const std::string& text, const std::string& word) {
    EXPECT_NE(text.find(word), std::string::npos) << text;
  };

  Problem problem = good;
  problem.upper[1] = HUGE_VAL;
  expect(message(problem, options), "x1: the bounds -1 .. inf must be finite");
  problem = good;
  problem.lower[0] = 2.0;
  expect(message(problem, options), "x0: the lower bound 2 is not below the upper bound 2");
  problem = good;
  problem.upper.pop_back();
  expect(message(problem, options), "must be equal");
  problem = good;
  problem.evaluate = nullptr;
  expect(message(problem, options), "evaluate is not set");
  problem = good;
  problem.n_cheap_constraints = 1;
  expect(message(problem, options), "cheap_constraints is not set");

  options.starts = {{0.0, 0.0}, {0.0, 2.5}};
  expect(message(good, options), "starting point 1: x1 = 2.5 is outside its bounds -1 .. 2");
  options.starts = {{std::nan(""), 0.0}};
  expect(message(good, options), "starting point 0: x0 = nan");
}

}  // namespace
}  // namespace parapet::optimizer
