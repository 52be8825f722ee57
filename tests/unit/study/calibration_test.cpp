// Of many small studies with a known truth, about 95 % of repeats lie in their 95 % intervals.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "parapet/math/normal.hpp"
#include "parapet/study/expected.hpp"
#include "parapet/study/pick.hpp"
#include "taught_study.hpp"

namespace parapet::test {
namespace {

namespace stage = study::confirmation_stage;

struct Values {
  double retention, launch;
};

/// The truth at a spacing: smooth, with an error of first order in the spacing.
Values truth(double height, double angle, double spacing) {
  const double s = (height - 0.04) / 0.06, a = angle / 60.0;
  return {0.55 + 0.25 * s + 0.08 * std::sin(3.0 * a) - 0.1 * s * a + (1.0 + s) * spacing,
          0.35 - 0.2 * s + 0.1 * std::cos(2.0 * a) + (1.0 - a) * spacing};
}

/// Runs of the truth with scatter.
class Experiment {
 public:
  explicit Experiment(unsigned seed) : generator_(seed) {}
  double uniform() { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; }
  double scatter() { return 0.01 * math::normal_quantile(uniform()); }
  Values run(double height, double angle, double spacing) {
    const Values exact = truth(height, angle, spacing);
    return {exact.retention + scatter(), exact.launch + scatter()};
  }

 private:
  std::mt19937_64 generator_;
};

struct Count {
  int inside = 0, all = 0;
  void add(const study::Expectation& expected, double value) {
    ++all;
    inside += value >= expected.estimate->lower_95().value() &&
                      value <= expected.estimate->upper_95().value()
                  ? 1
                  : 0;
  }
  double share() const { return static_cast<double>(inside) / all; }
};

/// A study of random designs, its recommendation (the best of them, so a lucky one) confirmed by
/// two runs near it, then repeated at a spacing.
void repeat_study(unsigned seed, const std::vector<double>& spacings, double repeated_at,
                  Count& count) {
  Experiment experiment(seed);
  TaughtStudy taught(spacings, 0.45);
  for (const double spacing : spacings) {
    for (int k = 0; k < (spacing == spacings.front() ? 14 : 20); ++k) {
      const double height = 0.04 + 0.06 * experiment.uniform();
      const double angle = 60.0 * experiment.uniform();
      const Values values = experiment.run(height, angle, spacing);
      taught.add(height, angle, spacing, values.retention, values.launch);
    }
  }
  taught.teach();
  const study::Choice choice = study::choose(taught.study, {});
  ASSERT_FALSE(choice.ranked.empty());
  const records::EvaluationRecord pick = *choice.ranked.front().design;
  const double height = pick.design.at("height_m"), angle = pick.design.at("angle_deg");
  for (const char* role : {"near-1", "near-2"}) {
    const Values values = experiment.run(height, angle, spacings.front());
    taught.confirm(pick.id, role, stage::near, spacings.front(), values.retention, values.launch);
  }
  const auto expected = study::repeat_expectations(taught.study, pick);
  const Values repeat = experiment.run(height, angle, repeated_at);
  count.add(expected.at(0), repeat.retention);
  count.add(expected.at(1), repeat.launch);
}

// 300 repeats of two quantities: 0.95 with a binomial s.d. of sqrt(0.95 0.05 / 300) = 0.013. The
// bounds 0.90 and 0.99 are 4 and 3 of them away; a method with 85 % or with 99.9 % lies outside.
TEST(Calibration, RepeatsLieInTheirIntervals) {
  Count count;
  for (unsigned seed = 1; seed <= 150; ++seed) repeat_study(seed, {0.01}, 0.01, count);
  EXPECT_GE(count.share(), 0.90) << count.inside << " of " << count.all;
  EXPECT_LE(count.share(), 0.99) << count.inside << " of " << count.all;
}

// The grid's part: the repeat is simulated at a spacing that the study never saw. Its change from
// 10 to 7 mm is 0.3 of that from 20 to 10 mm, which counts as one standard uncertainty, so that
// more than 95 % are inside; without it, of a change of up to 0.006 at a scatter of 0.01, fewer
// than 95 %.
TEST(Calibration, RepeatsAtAFinerSpacingDoToo) {
  Count count;
  for (unsigned seed = 1; seed <= 60; ++seed) repeat_study(seed, {0.01, 0.02}, 0.007, count);
  // 120 repeats: s.d. 0.020; 0.90 is 2.5 of them below 0.95.
  EXPECT_GE(count.share(), 0.90) << count.inside << " of " << count.all;
}

// What the test would not see if it let everything pass: the luckiest run as the mean, and the
// surrogate's doubt of the noise-free value as the uncertainty, as it once was.
TEST(Calibration, TheLuckiestRunIsNotWhatARepeatGives) {
  Count count;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Experiment experiment(seed);
    double best = -1e9;
    for (int k = 0; k < 14; ++k) best = std::max(best, experiment.scatter());
    study::Expectation lucky;
    lucky.estimate = study::repeat_estimate(
        {.surrogate = study::SurrogateBelief{.mean = best, .deviation = 0.005, .noise = 0.0}});
    count.add(lucky, experiment.scatter());
  }
  EXPECT_LT(count.share(), 0.75);
}

}  // namespace
}  // namespace parapet::test
