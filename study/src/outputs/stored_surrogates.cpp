#include "stored_surrogates.hpp"

#include <stdexcept>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/whole_number.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/front.hpp"
#include "parapet/study/sensitivity.hpp"

namespace parapet::study {
namespace {

using designs::Json;

constexpr int fewest_designs = 5;

surrogate::TransformKind transform_kind(const std::string& name) {
  if (name == "identity") return surrogate::TransformKind::identity;
  if (name == "log") return surrogate::TransformKind::log;
  if (name == "bilog") return surrogate::TransformKind::bilog;
  throw std::invalid_argument("there is no transform \"" + name + "\"");
}

Eigen::VectorXd vector_of(const Json& json) {
  const auto values = json.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Eigen::MatrixXd matrix_of(const Json& rows) {
  Eigen::MatrixXd matrix;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Eigen::VectorXd row = vector_of(rows[i]);
    if (i == 0) matrix.resize(static_cast<Eigen::Index>(rows.size()), row.size());
    if (row.size() != matrix.cols()) throw std::invalid_argument("inputs of unequal length");
    matrix.row(static_cast<Eigen::Index>(i)) = row.transpose();
  }
  return matrix;
}

surrogate::Parameters parameters_of(const Json& json) {
  surrogate::Parameters parameters;
  const Json& transform = json.at("transform");
  parameters.transform = {.kind = transform_kind(transform.at("kind").get<std::string>()),
                          .unit = transform.at("unit").get<double>(),
                          .shift = transform.at("shift").get<double>(),
                          .scale = transform.at("scale").get<double>()};
  for (const Json& level : json.at("levels")) {
    surrogate::LevelParameters one;
    one.length_scales = vector_of(level.at("length_scales"));
    one.amplitude = level.at("amplitude").get<double>();
    one.noise = level.at("noise").get<double>();
    one.mean = level.at("mean").get<double>();
    one.coupling = level.at("coupling").get<double>();
    parameters.levels.push_back(std::move(one));
  }
  return parameters;
}

/// Fits surrogates to what is logged, statistics being those of the simulated events; null when
/// that is too little.
Json fitted_surrogates(const designs::StudySpec& study, const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return nullptr;
  const SearchProblem problem = make_search_problem(study);
  bayesian::Search search(problem.problem, make_search_options(study));
  int good = 0;
  for (const records::EvaluationRecord& record : records::read_evaluation_log(file).records) {
    const std::optional<int> level = level_of(problem, record.spacing);
    if (!level || !designs::check_design(study, record.design, "").empty()) continue;
    search.tell_external(to_point(study, record.design), *level,
                         observation(study, problem, record));
    good += record.ok ? 1 : 0;
  }
  return good < fewest_designs ? Json() : surrogates_json(study, problem, search);
}

}  // namespace

std::optional<surrogate::GaussianProcess> stored_process(const Json& surrogates,
                                                         const Json& metric) {
  if (!metric.contains("surrogate") || metric["surrogate"].is_null()) return std::nullopt;
  const Json& process = metric["surrogate"];
  const surrogate::Layout layout{
      .group = records::whole_numbers<int>(surrogates.at("/layout/group"_json_pointer)),
      .n_levels = records::whole_number<int>(surrogates.at("/layout/n_levels"_json_pointer))};
  const Json& stored = process.at("data");
  const surrogate::Data data{.inputs = matrix_of(stored.at("inputs")),
                             .values = vector_of(stored.at("values")),
                             .levels = records::whole_numbers<int>(stored.at("levels"))};
  surrogate::FitOptions options;
  options.warm_start = parameters_of(process);
  options.transform = options.warm_start->transform.kind;
  options.keep_parameters = true;
  return surrogate::GaussianProcess::fit(layout, data, options);
}

Json study_surrogates(const designs::StudySpec& study, const std::filesystem::path& folder,
                      std::string& source) {
  const std::filesystem::path file = folder / "surrogates.json";
  if (std::filesystem::exists(file)) {
    Json json = Json::parse(records::read_file(file), nullptr, false);
    if (json.is_object() && json.value("spec_hash", "") == records::study_hash(study)) {
      source = "surrogates.json";
      return json;
    }
  }
  source = "evaluations.jsonl";
  return fitted_surrogates(study, folder / "evaluations.jsonl");
}

}  // namespace parapet::study
