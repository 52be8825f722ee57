#include <gtest/gtest.h>

#include <cmath>

#include "parapet/designs/study_spec.hpp"

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

}  // namespace
}  // namespace parapet::designs
