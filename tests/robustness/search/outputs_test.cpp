// pareto.json and surrogates.json: true to the log, and enough to predict again.
#include <cmath>

#include "fake_study.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/front.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using surrogate::GaussianProcess;

class Outputs : public FakeStudyTest {};

Eigen::VectorXd vector_of(const Json& json) {
  const auto values = json.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The process that a metric's entry describes, without any fitting.
GaussianProcess process_of(const Json& file, const Json& metric) {
  const Json& model = metric["surrogate"];
  surrogate::Layout layout;
  layout.group = file["layout"]["group"].get<std::vector<int>>();
  layout.n_levels = file["layout"]["n_levels"].get<int>();
  surrogate::Data data;
  data.values = vector_of(model["data"]["values"]);
  data.levels = model["data"]["levels"].get<std::vector<int>>();
  data.inputs.resize(data.values.size(), static_cast<Eigen::Index>(layout.group.size()));
  for (Eigen::Index i = 0; i < data.values.size(); ++i) {
    data.inputs.row(i) = vector_of(model["data"]["inputs"][static_cast<std::size_t>(i)]);
  }
  surrogate::Parameters parameters;
  const std::string kind = model["transform"]["kind"].get<std::string>();
  using surrogate::TransformKind;
  parameters.transform = {kind == "log"     ? TransformKind::log
                          : kind == "bilog" ? TransformKind::bilog
                                            : TransformKind::identity,
                          model["transform"]["unit"].get<double>(),
                          model["transform"]["shift"].get<double>(),
                          model["transform"]["scale"].get<double>()};
  for (const Json& level : model["levels"]) {
    surrogate::LevelParameters one;
    one.length_scales = vector_of(level["length_scales"]);
    one.amplitude = level["amplitude"].get<double>();
    one.noise = level["noise"].get<double>();
    one.mean = level["mean"].get<double>();
    one.coupling = level["coupling"].get<double>();
    parameters.levels.push_back(one);
  }
  surrogate::FitOptions options;
  options.warm_start = parameters;
  options.keep_parameters = true;
  return GaussianProcess::fit(layout, data, options);
}

TEST_F(Outputs, SurrogatesFileIsEnoughToPredictAgain) {
  const auto study = parsed(fake_study());
  run(study, "out", FakeSimulator());
  const Json file = json("out", "surrogates.json");
  EXPECT_EQ(file["format"], "parapet-surrogates/1");
  const Json pareto = json("out", "pareto.json");
  ASSERT_GE(pareto["designs"].size(), 1U);
  const auto space = study::make_space(study);
  for (std::size_t j = 0; j < 2; ++j) {
    const GaussianProcess process = process_of(file, file["metrics"][j]);
    for (const Json& design : pareto["designs"]) {
      const auto point = study::to_point(study, design["design"].get<designs::Design>());
      const auto prediction = process.predict(space.features(point), 0);
      const double median = process.from_model(prediction.mean[0]);
      // Bounds of the metric may clip the search's estimate: a force is at least 0.
      EXPECT_NEAR(std::max(0.0, design["objectives"][j]["estimate"].get<double>()),
                  std::max(0.0, median), 1e-9);
      EXPECT_LE(design["objectives"][j]["lower_95"], design["objectives"][j]["upper_95"]);
    }
  }
}

TEST_F(Outputs, HypervolumeGrowsAndEndsAtTheFrontsOwn) {
  Json json = fake_study();
  json["objectives"][0]["reference"] = 1.5;
  json["objectives"][1]["reference"] = 1.5;
  const auto summary = run(parsed(json), "out", FakeSimulator());
  const Json pareto = this->json("out", "pareto.json");
  EXPECT_EQ(pareto["objectives"][0]["reference"], 1.5);
  ASSERT_EQ(pareto["history"].size(), 14U);
  double before = 0.0;
  for (const Json& entry : pareto["history"]) {
    EXPECT_GE(entry["hypervolume"].get<double>(), before);
    before = entry["hypervolume"].get<double>();
  }
  EXPECT_NEAR(before, summary.hypervolume, 1e-12);
  EXPECT_EQ(pareto["hypervolume"], summary.hypervolume);
  EXPECT_EQ(pareto["history"][13]["cpu_time_s"], 14.0);
  const Json on_disk = this->json("out", "summary.json");
  EXPECT_EQ(on_disk["pareto_size"], summary.pareto.size());
  EXPECT_TRUE(on_disk["optimizer_time_s"].is_number());
}

records::EvaluationRecord made_record(const std::string& id, double f1, double f2, bool feasible,
                                      double spacing) {
  records::EvaluationRecord record;
  record.id = id;
  record.ok = true;
  record.feasible = feasible;
  record.spacing = spacing;
  record.cpu_time = 2.0;
  record.objectives = {{"f1", designs::Goal::minimize, 1.0, f1, false},
                       {"f2", designs::Goal::minimize, 1.0, f2, false}};
  return record;
}

TEST(Fronts, CountFeasibleDesignsAtTheFinestSpacingOnly) {
  Json json = fake_study();
  json["objectives"][0]["reference"] = 4.0;
  json["objectives"][1]["reference"] = 4.0;
  json["fidelity"] = Json::parse(R"({"spacings_m": [0.01, 0.02]})");
  const auto study = parsed(json);
  const auto front = study::make_front(
      study, {made_record("0001", 1.0, 3.0, true, 0.01), made_record("0002", 0.0, 0.0, true, 0.02),
              made_record("0003", 0.5, 0.5, false, 0.01), made_record("0004", 3.0, 1.0, true, 0.01),
              made_record("0005", 3.0, 3.0, true, 0.01)});
  ASSERT_EQ(front.designs.size(), 2U);
  EXPECT_EQ(front.designs[0].id, "0001");
  EXPECT_EQ(front.designs[1].id, "0004");
  // Two boxes of 3 x 1 that share 1 x 1.
  EXPECT_NEAR(front.hypervolume, 5.0, 1e-12);
  ASSERT_EQ(front.history.size(), 5U);
  EXPECT_NEAR(front.history[2].hypervolume, 3.0, 1e-12);
  EXPECT_NEAR(front.history[4].cpu_time, 10.0, 1e-12);
}

}  // namespace
}  // namespace parapet::test
