#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "interruptible.hpp"
#include "json_objects.hpp"
#include "parapet/cli/run_parapet.hpp"
#include "parapet/reports/recommendation.hpp"
#include "parapet/reports/recommendation_json.hpp"
#include "parapet/reports/recommendation_text.hpp"
#include "parapet/study/confirm.hpp"
#include "parapet/study/loaded_study.hpp"
#include "parapet/study/pick.hpp"
#include "parapet/study/sensitivity.hpp"
#include "parts.hpp"

namespace parapet::python {
namespace {

namespace py = pybind11;
using designs::Json;

struct Advice {
  Json json;
  std::string text;
};

void confirm(const study::LoadedStudy& study, const study::PickRule& rule, int repeats, int jobs,
             const std::atomic<bool>& cancelled) {
  study::ConfirmOptions options;
  options.folder = study.folder;
  options.repeats = repeats;
  options.jobs = jobs;
  options.program = cli::program_info();
  options.hooks.cancelled = [&] { return cancelled.load(); };
  study::confirm_picks(study.spec, study::ranked_picks(study, rule), options);
}

Advice advise(const std::string& folder, const study::PickRule& rule, bool confirmed, int repeats,
              int jobs, const std::atomic<bool>& cancelled) {
  study::LoadedStudy study = study::load_study_folder(folder);
  study::ranked_picks(study, rule);  // what is wrong with the rule is said first
  if (confirmed) {
    confirm(study, rule, repeats, jobs, cancelled);
    study.confirmations = study::load_confirmations(folder);
  }
  std::string source;
  const Json surrogates = study::study_surrogates(study.spec, study.folder, source);
  if (!surrogates.is_null()) {
    study.sensitivity = study::study_sensitivity(study.spec, surrogates, source);
  }
  const reports::Recommendation recommendation = reports::recommend(study, rule);
  return {reports::recommendation_json(recommendation),
          reports::recommendation_text(recommendation)};
}

py::tuple recommend(const std::string& folder, const std::string& rule, const std::string& weights,
                    const std::vector<std::string>& limits, bool confirmed, int repeats, int jobs) {
  const study::PickRule parsed = study::parse_pick_rule(rule, weights, limits);
  const Advice advice = run_interruptibly([&](const std::atomic<bool>& cancelled) {
    return advise(folder, parsed, confirmed, repeats, jobs, cancelled);
  });
  return py::make_tuple(to_python(advice.json), advice.text);
}

/// {name, spec, state, records, confirmations, damage} of a study's folder.
py::dict load_folder(const std::string& folder) {
  const study::LoadedStudy study = study::load_study_folder(folder);
  const auto list = [](const std::vector<records::EvaluationRecord>& records) {
    py::list out;
    for (const auto& record : records) out.append(to_python(records::to_json(record)));
    return out;
  };
  py::dict out;
  out["study"] = study.spec;
  out["state"] = study.state;
  out["records"] = list(study.designs);
  out["confirmations"] = list(study.confirmations);
  out["damage"] = study.damage;
  return out;
}

}  // namespace

void add_advice(py::module_& module) {
  module.def("recommend", &recommend);
  module.def("load_folder", &load_folder);
}

}  // namespace parapet::python
