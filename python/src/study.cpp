#include <pybind11/stl.h>

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interruptible.hpp"
#include "json_objects.hpp"
#include "parapet/cli/run_parapet.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/study/design_stream.hpp"
#include "parapet/study/experiments.hpp"
#include "parapet/study/external_record.hpp"
#include "parapet/study/local_service.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/spec_files.hpp"
#include "parts.hpp"

namespace parapet::python {
namespace {

namespace py = pybind11;
using designs::Json;
using designs::StudySpec;

/// A design as Python asks for it: its JSON, particle spacing [m] or the finest, scenario or all.
struct Question {
  std::string design;
  std::optional<double> spacing;
  std::string scenario;
};

designs::Design design_of(const StudySpec& study, const std::string& text) {
  designs::DesignReading reading =
      designs::read_design(study, designs::parse_json(text, "the design"), "the design");
  if (!reading.issues.empty()) throw designs::InputError(std::move(reading.issues));
  return std::move(reading.design);
}

const designs::Scenario* scenario_of(const StudySpec& study, const std::string& name) {
  if (name.empty()) return nullptr;
  for (const designs::Scenario& one : study.scenarios) {
    if (one.name == name) return &one;
  }
  throw py::key_error("the study " + study.name + " has no scenario " + name);
}

StudySpec checked(StudySpec study) {
  if (auto issues = study::method_issues(study); !issues.empty()) {
    throw designs::InputError(std::move(issues));
  }
  return study;
}

study::StreamedDesign streamed(const StudySpec& study, const Question& question,
                               std::size_t number) {
  scenario_of(study, question.scenario);
  return {.number = number,
          .design = design_of(study, question.design),
          .spacing = question.spacing.value_or(designs::finest_spacing(study)),
          .scenario = question.scenario};
}

using Records = std::vector<std::optional<records::EvaluationRecord>>;

/// One design: its events side by side, threads of each where there are fewer events than jobs.
records::EvaluationRecord evaluate_one(const StudySpec& study, const study::StreamedDesign& asked,
                                       int jobs, const std::atomic<bool>& cancelled) {
  const StudySpec one =
      asked.scenario.empty() ? study : study::with_one_scenario(study, asked.scenario);
  const auto service = study::local_service()(
      jobs, {.cancelled = [&] { return cancelled.load(); }, .on_progress = {}});
  const auto run = study::run_design(one, asked.design, asked.spacing, *service);
  if (!run) throw std::runtime_error("cancelled");
  return study::external_record(*run, cli::program_info());
}

/// Several: as many simulations side by side as there are jobs.
Records evaluate_many(const StudySpec& study, std::vector<study::StreamedDesign> asked, int jobs,
                      const std::atomic<bool>& cancelled) {
  Records records(asked.size());
  study::DesignStream stream(
      study, jobs, {.cancelled = [&] { return cancelled.load(); }, .on_progress = {}},
      [&](const study::StreamedDesign& design, const study::DesignRun& run) {
        records[design.number] = study::external_record(run, cli::program_info());
      });
  for (study::StreamedDesign& one : asked) stream.put(std::move(one));
  stream.finish();
  return records;
}

py::list evaluate(
    const StudySpec& study,
    const std::vector<std::tuple<std::string, std::optional<double>, std::string>>& questions,
    int jobs) {
  std::vector<study::StreamedDesign> asked;
  for (const auto& [design, spacing, scenario] : questions) {
    asked.push_back(streamed(study, {design, spacing, scenario}, asked.size()));
  }
  const Records records = run_interruptibly([&](const std::atomic<bool>& cancelled) {
    if (asked.size() == 1) return Records{evaluate_one(study, asked.front(), jobs, cancelled)};
    return evaluate_many(study, asked, jobs, cancelled);
  });
  py::list out;
  for (const auto& record : records) out.append(to_python(records::to_json(record.value())));
  return out;
}

py::object design_case(const StudySpec& study, const std::string& design,
                       const std::string& scenario, std::optional<double> spacing) {
  return to_python(designs::design_case(study, design_of(study, design),
                                        scenario_of(study, scenario),
                                        spacing.value_or(designs::finest_spacing(study)))
                       .resolved);
}

py::list variables(const StudySpec& study) {
  py::list out;
  for (const designs::Variable& variable : study.variables) {
    py::list options;
    for (const designs::Option& option : variable.options) options.append(option.name);
    const char* kind = variable.kind == designs::VariableKind::continuous ? "continuous"
                       : variable.kind == designs::VariableKind::integer  ? "integer"
                                                                          : "choice";
    out.append(py::make_tuple(variable.name, kind, variable.lower, variable.upper, options));
  }
  return out;
}

}  // namespace

void add_study(py::module_& module) {
  py::class_<StudySpec>(module, "Study")
      .def_static("load",
                  [](const std::string& argument, std::optional<double> spacing_mm) {
                    return checked(study::read_study(argument, spacing_mm));
                  })
      .def_static(
          "parse",
          [](const std::string& text, const std::string& file, std::optional<double> spacing_mm) {
            return checked(study::study_of({designs::parse_json(text, file), file}, spacing_mm));
          })
      .def_readonly("name", &StudySpec::name)
      .def_readonly("source_file", &StudySpec::source_file)
      .def("resolved", [](const StudySpec& study) { return to_python(study.resolved); })
      .def("hash", [](const StudySpec& study) { return records::study_hash(study); })
      .def("variables", &variables)
      .def("scenarios",
           [](const StudySpec& study) {
             std::vector<std::pair<std::string, double>> all;
             for (const auto& one : study.scenarios) all.emplace_back(one.name, one.weight);
             return all;
           })
      .def("objectives",
           [](const StudySpec& study) {
             std::vector<std::pair<std::string, bool>> all;  // name, whether maximised
             for (const auto& one : study.objectives) {
               all.emplace_back(study::objective_name(one), one.goal == designs::Goal::maximize);
             }
             return all;
           })
      .def("spacings",
           [](const StudySpec& study) {
             std::vector<double> all;
             for (const auto& level : study.fidelity) all.push_back(level.spacing);
             return all;
           })
      .def("violations",
           [](const StudySpec& study, const std::string& design) {
             return study::expression_violations(study, design_of(study, design));
           })
      .def("written_design",
           [](const StudySpec& study, const std::string& design) {
             return to_python(designs::design_json(study, design_of(study, design)));
           })
      .def("design_case", &design_case)
      .def("evaluate", &evaluate);
}

}  // namespace parapet::python
