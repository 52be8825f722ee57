#include "parapet/study/confirm.hpp"

#include <cmath>

#include "formula_study.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/records/folder_lock.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::test {
namespace {

using designs::Design;
using study::Pick;

const Design with_plate{{"height_m", 0.07}, {"deflector", 1.0}, {"angle_deg", 30.0}};
const Design without{{"height_m", 0.07}, {"deflector", 0.0}};

designs::StudySpec study_of(const designs::Json& json) {
  return designs::parse_study(json, "test");
}

/// The launch length is the scaled height: a barrier above 0.07 m breaks the limit of 0.5.
class Confirm : public FolderTest {
 protected:
  study::ConfirmOutcome confirm(const designs::StudySpec& study, const std::vector<Pick>& picks,
                                std::optional<double> spacing = {}, int jobs = 1) {
    study::ConfirmOptions options;
    options.folder = folder;
    options.spacing = spacing;
    options.jobs = jobs;
    options.service = study::local_service(simulator);
    return study::confirm_picks(study, picks, options);
  }

  std::vector<records::EvaluationRecord> lines() const {
    return records::EvaluationLog(folder / "confirmations.jsonl").records();
  }

  FormulaSimulator simulator{[](const Design&) { return 0.9; }, scaled_height};
};

TEST(NearDesigns, MoveEveryContinuousVariableAndNothingElse) {
  const designs::StudySpec study = study_of(formula_study());
  const auto near = study::near_designs(study, with_plate, 3);
  ASSERT_EQ(near.size(), 3U) << "four corners, all allowed";
  for (const Design& design : near) {
    EXPECT_NEAR(std::abs(design.at("height_m") - 0.07), 0.005 * 0.06, 1e-15);
    EXPECT_NEAR(std::abs(design.at("angle_deg") - 30.0), 0.005 * 60.0, 1e-12);
    EXPECT_EQ(design.at("deflector"), 1.0);
  }
  EXPECT_EQ(near, study::near_designs(study, with_plate, 3)) << "the same on every call";
  EXPECT_EQ(study::near_designs(study, with_plate, 9).size(), 4U) << "there are no more";
  EXPECT_EQ(study::near_designs(study, without, 9).size(), 2U) << "the height alone";
}

TEST(NearDesigns, StayWithinBoundsAndFormulas) {
  const designs::StudySpec study = study_of(formula_study());
  // At both upper bounds: only inwards.
  const Design corner{{"height_m", 0.1}, {"deflector", 0.0}};
  const auto near = study::near_designs(study, corner, 5);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_NEAR(near[0].at("height_m"), 0.1 - 0.005 * 0.06, 1e-15);
  // On the formula's limit, height + angle / 1000 = 0.15: not both up.
  const Design edge{{"height_m", 0.099}, {"deflector", 1.0}, {"angle_deg", 51.0}};
  for (const Design& design : study::near_designs(study, edge, 9)) {
    for (const double violation : study::expression_violations(study, design)) {
      EXPECT_LE(violation, study::feasibility_tolerance);
    }
  }
}

TEST_F(Confirm, RunsNearDesignsOnceAndKeepsThem) {
  const designs::StudySpec study = study_of(formula_study());
  const Pick pick{"0004", {{"height_m", 0.05}, {"deflector", 0.0}}, 0.01, {}};
  const auto first = confirm(study, {pick});
  EXPECT_EQ(first.confirmed, "0004");
  EXPECT_EQ(first.simulated, 2);
  EXPECT_EQ(simulator.asked().size(), 2U) << "the pick itself was observed at the finest spacing";
  const auto log = lines();
  ASSERT_EQ(log.size(), 2U);
  EXPECT_EQ(log[0].id, "0004-near-1");
  EXPECT_EQ(log[0].stage, "confirm-near");
  EXPECT_EQ(log[0].options.at("deflector"), "none");
  EXPECT_TRUE(log[0].feasible);
  const auto second = confirm(study, {pick});
  EXPECT_EQ(second.simulated, 0);
  EXPECT_EQ(second.confirmed, "0004");
  EXPECT_EQ(simulator.asked().size(), 2U);
  EXPECT_EQ(lines().size(), 2U);
}

TEST_F(Confirm, EveryScenarioIsSimulatedAndScored) {
  designs::Json json = formula_study();
  json["scenarios"] = designs::Json::parse(R"([
    {"name": "soft", "weight": 0.25, "set": {"yield_stress_pa": 50}},
    {"name": "stiff", "weight": 0.75, "set": {"yield_stress_pa": 200}}])");
  const designs::StudySpec study = study_of(json);
  const auto outcome =
      confirm(study, {{"0004", {{"height_m", 0.05}, {"deflector", 0.0}}, 0.01, {}}}, {}, 3);
  EXPECT_EQ(outcome.simulated, 2);
  EXPECT_EQ(simulator.asked().size(), 4U);
  for (const auto& line : lines()) ASSERT_EQ(line.scenarios.size(), 2U);
}

TEST_F(Confirm, SpacingsOfTheUserAndTheStudysFinest) {
  const designs::StudySpec study = study_of(formula_study());
  // Observed at 20 mm only, the study's finest is 10 mm, the user wants 5 mm.
  confirm(study, {{"0004", {{"height_m", 0.05}, {"deflector", 0.0}}, 0.02, {}}}, 0.005);
  std::map<std::string, double> spacings;
  for (const auto& line : lines()) spacings[line.id] = line.spacing;
  EXPECT_EQ(spacings, (std::map<std::string, double>{{"0004-5mm", 0.005},
                                                     {"0004-finest", 0.01},
                                                     {"0004-near-1", 0.01},
                                                     {"0004-near-2", 0.01}}));
}

TEST_F(Confirm, TheNextIsTriedWhenOneDoesNotHold) {
  const designs::StudySpec study = study_of(formula_study());
  const auto pick = [](const char* id, double height) {
    return Pick{id, {{"height_m", height}, {"deflector", 0.0}}, 0.01, {}};
  };
  const auto outcome = confirm(study, {pick("0001", 0.09), pick("0002", 0.08), pick("0003", 0.05)});
  EXPECT_EQ(outcome.refuted, (std::vector<std::string>{"0001", "0002"}));
  EXPECT_EQ(outcome.confirmed, "0003");
  // Three at most.
  const auto hopeless = confirm(
      study, {pick("0011", 0.09), pick("0012", 0.085), pick("0013", 0.08), pick("0014", 0.05)});
  EXPECT_EQ(hopeless.refuted.size(), 3U);
  EXPECT_FALSE(hopeless.confirmed);
}

TEST_F(Confirm, ACancelledConfirmationGoesOn) {
  const designs::StudySpec study = study_of(formula_study());
  const std::vector<Pick> picks{{"0004", {{"height_m", 0.05}, {"deflector", 0.0}}, 0.01, {}}};
  simulator.cancel_after(1);
  const auto cut = confirm(study, picks);
  EXPECT_TRUE(cut.cancelled);
  EXPECT_FALSE(cut.confirmed);
  EXPECT_EQ(lines().size(), 1U);
  simulator.go_on();
  const auto whole = confirm(study, picks);
  EXPECT_EQ(whole.simulated, 1) << "the first run is not repeated";
  EXPECT_EQ(whole.confirmed, "0004");
}

TEST_F(Confirm, AFolderInUseIsLeftAlone) {
  const designs::StudySpec study = study_of(formula_study());
  const records::FolderLock lock(folder);
  const auto outcome = confirm(study, {{"0004", without, 0.01, {}}});
  EXPECT_FALSE(outcome.refusal.empty());
  EXPECT_TRUE(simulator.asked().empty());
  EXPECT_FALSE(std::filesystem::exists(folder / "confirmations.jsonl"));
}

}  // namespace
}  // namespace parapet::test
