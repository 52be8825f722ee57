#include <gtest/gtest.h>

#include <cmath>

#include "parapet/designs/study_spec.hpp"
#include "study_parts.hpp"

namespace parapet::designs {
namespace {

const Design design{{"deflector_angle_deg", 30.0}, {"height_m", 0.1}, {"length_m", 0.065}};

TEST(Expression, Evaluates) {
  EXPECT_DOUBLE_EQ(evaluate_expression("height_m + length_m", design), 0.165);
  EXPECT_DOUBLE_EQ(evaluate_expression("2 * height_m - length_m / 2", design), 0.1675);
  // 1e-12: muParser's _pi has 15 digits
  EXPECT_NEAR(
      evaluate_expression("height_m + length_m * sin(deflector_angle_deg * _pi / 180)", design),
      0.1 + 0.065 * 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(evaluate_expression("height_m > 0.05 ? 1 : 2", design), 1.0);
  EXPECT_DOUBLE_EQ(evaluate_expression("max(height_m, length_m)", design), 0.1);
}

// The design is a value: nothing an expression does may change it.
TEST(Expression, CannotChangeTheDesign) {
  const Design before = design;
  try {
    evaluate_expression("height_m = 5", design);
  } catch (const InputError&) {
  }
  EXPECT_EQ(design, before);
}

TEST(Expression, NamesWhatItCannotRead) {
  try {
    evaluate_expression("height_m + lenght_m", design);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("unknown symbol \"lenght_m\" at character 12"),
              std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("did you mean \"length_m\"?"), std::string::npos);
  }
}

// A value that does not exist is an error, never an infinity that wanders into a search.
TEST(Expression, RefusesValuesThatAreNotFinite) {
  EXPECT_THROW(evaluate_expression("1 / (height_m - 0.1)", design), InputError);
  EXPECT_THROW(evaluate_expression("sqrt(-height_m)", design), InputError);
}

const std::vector<std::string> names{"a", "b", "height_m"};

// What people mean by a formula.
TEST(Grammar, TakesNumbersNamesOperatorsFunctionsAndConditions) {
  for (const char* formula :
       {"a", "-a + 2.5e-3 * b", "a^2 / (b - .5)", "2^-a", "max(a, b)", "max(0.5, a)",
        "min(1, a, b)", "a < b ? a : b", "a <= 1 && b != 2 || height_m > 1 ? 1 : 0 * a",
        "(a < b ? 1 : 2) * a", "a<b?a:b>1?b:2", "sin(a * _pi / 180)", " a\t+\n1 ", "+a", "5. * a",
        "1E3*a"}) {
    EXPECT_EQ(expression_problem(formula, names).problem, "") << formula;
  }
}

struct Unmeant {
  const char* formula;
  const char* problem;
};

// The parser would take each of these in silence.
TEST(Grammar, RefusesWhatNobodyMeans) {
  for (const Unmeant& one :
       std::vector<Unmeant>{{"0,5 * a", "comma at character 2 outside"},
                            {"a, b", "comma at character 2 outside"},
                            {"(a, b)", "comma at character 3 outside"},
                            {"a + (0,5)", "comma at character 7 outside"},
                            {"max(0,5, a)", "comma between two digits at character 6"},
                            {"sum(1,5,a)", "comma between two digits"},
                            {"a = 0.1", "is a comparison"},
                            {"a < b", "is a comparison"},
                            {"(a < b)", "is a comparison"},
                            {"max(a < b, 1)", "is a comparison"},
                            {"(a < b) + a", "calculates with a comparison"},
                            {"a * (a == b)", "calculates with a comparison"},
                            {"-(a < b)", "calculates with a comparison"},
                            {"a < b < height_m", "is a comparison"},
                            {"a ? 1 : 2", "a number at character 1 where a condition"},
                            {"a && b", "joins numbers"},
                            {"a || b ? 1 : 2", "joins numbers"}}) {
    const ExpressionProblem found = expression_problem(one.formula, names);
    EXPECT_FALSE(found.problem.empty()) << one.formula << " is taken";
    EXPECT_FALSE(found.allowed.empty()) << one.formula;
    EXPECT_NE(found.problem.find(one.problem), std::string::npos)
        << one.formula << ": " << found.problem;
  }
}

// Refused by the parser or by the grammar, with whichever reason.
TEST(Grammar, RefusesWhatIsNoFormula) {
  const std::string deep = std::string(5000, '(') + "a" + std::string(5000, ')');
  for (const std::string& formula :
       std::vector<std::string>{"",    " ",     "\"a\"", "a b",     "2a",  "a;b",   "1.2.3*a",
                                "a +", "max(a", "max()", "max(a,)", "a)",  "a % b", "a += 1",
                                "a²",  "a × b", "1e*a",  "0x10*a",  "a:b", "a?b",   deep}) {
    EXPECT_FALSE(expression_problem(formula, names).problem.empty()) << formula.substr(0, 20);
  }
}

}  // namespace
}  // namespace parapet::designs
