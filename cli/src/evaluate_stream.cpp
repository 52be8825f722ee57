#include <algorithm>
#include <cstddef>
#include <map>
#include <mutex>
#include <optional>

#include "evaluate_options.hpp"
#include "interrupt.hpp"
#include "parapet/records/study_folder.hpp"
#include "parapet/study/design_stream.hpp"
#include "parapet/study/external_record.hpp"
#include "spec_files.hpp"

namespace parapet::cli {
namespace {

using designs::InputError;
using designs::InputIssue;
using designs::Json;

/// A line of the input as it was understood.
struct Line {
  Json id;
  study::StreamedDesign asked;
};

[[noreturn]] void refuse(const std::string& source, const std::string& pointer, const Json& value,
                         const std::string& problem, const std::string& allowed) {
  throw InputError({{source, pointer, value.is_null() ? "" : value.dump(), problem, allowed}});
}

/// Whether the line says more than the design.
bool is_envelope(const Json& json) {
  return json.is_object() && json.contains("design") && json["design"].is_object();
}

std::string scenario_names(const designs::StudySpec& study) {
  std::string names;
  for (const auto& scenario : study.scenarios) names += (names.empty() ? "" : ", ") + scenario.name;
  return names.empty() ? "none: the study has no scenarios" : names;
}

void read_envelope(const designs::StudySpec& study, const Json& json, const std::string& source,
                   study::StreamedDesign& asked) {
  for (const auto& [key, value] : json.items()) {
    if (key == "design") continue;
    if (key == "id") {
      if (!value.is_string() && !value.is_number_integer()) {
        refuse(source, "/id", value, "is no id", "a text or a whole number");
      }
    } else if (key == "scenario") {
      const bool known =
          value.is_string() && std::ranges::count(study.scenarios, value.get<std::string>(),
                                                  &designs::Scenario::name) > 0;
      if (!known)
        refuse(source, "/scenario", value, "is no scenario of the study", scenario_names(study));
      asked.scenario = value.get<std::string>();
    } else if (key == "spacing_mm") {
      constexpr double finest = 0.2, coarsest = 1000.0;
      const double mm = value.is_number() ? value.get<double>() : 0.0;
      if (!(mm >= finest && mm <= coarsest)) {
        refuse(source, "/spacing_mm", value, "is no particle spacing", "0.2 to 1000");
      }
      asked.spacing = mm / 1000.0;
    } else {
      refuse(source, "/" + key, value, "is an unknown key", "design, id, scenario, spacing_mm");
    }
  }
}

/// Answers a stream line by line.
class Stream {
 public:
  Stream(const Session& session, const EvaluateOptions& options)
      : session_(session),
        options_(options),
        study_(read_study(options.spec, options.spacing_mm)),
        designs_(study_, options.jobs,
                 {.cancelled = [this] { return stopped(); }, .on_progress = {}},
                 [this](const study::StreamedDesign& asked, const study::DesignRun& run) {
                   answer(asked, run);
                 }) {
    if (options.log_folder.empty()) return;
    folder_.emplace(options.log_folder, study_, session.program,
                    records::FolderOptions{.mix_physics = options.mix_revisions});
    for (const std::string& note : folder_->notes()) session.log->warn("{}", note);
    folder_->begin({.jobs = options.jobs, .max_evaluations = study_.method.max_evaluations});
  }

  int run() {
    InputLines input([this] { return stopped(); });
    std::string text;
    auto state = InputLines::State::line;
    while ((state = input.next(text)) == InputLines::State::line) {
      if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
      begin(input.number(), text);
    }
    const bool all = state == InputLines::State::end && designs_.finish();
    if (folder_) folder_->close();
    if (all) return exit_done;
    if (session_.out->error() != 0) return exit_failed;
    session_.log->error("interrupted; designs without a record on standard output were not logged");
    return exit_interrupted;
  }

 private:
  /// Interrupted, or nobody reads the answers any more.
  bool stopped() const { return interrupted() || session_.out->error() != 0; }

  void begin(std::size_t number, const std::string& text) {
    const std::string source = "line " + std::to_string(number);
    Json id = std::to_string(number);
    try {
      const Json json = designs::parse_json(text, source);
      const bool envelope = is_envelope(json);
      if (envelope) id = json.value("id", id);
      study::StreamedDesign asked{.number = number,
                                  .design = {},
                                  .spacing = designs::finest_spacing(study_),
                                  .scenario = {}};
      if (envelope) read_envelope(study_, json, source, asked);
      designs::DesignReading reading =
          designs::read_design(study_, envelope ? json["design"] : json, source);
      if (!reading.issues.empty()) throw InputError(std::move(reading.issues));
      asked.design = std::move(reading.design);
      require_loggable(asked, source);
      if (answered_from_log(id, asked)) return;
      {
        const std::scoped_lock lock(mutex_);
        ids_.emplace(number, id);
      }
      designs_.put(std::move(asked));
    } catch (const InputError& error) {
      print_error(id, error);
    }
  }

  /// A log holds designs under all events, at the spacings of the study.
  void require_loggable(const study::StreamedDesign& asked, const std::string& source) const {
    if (!folder_) return;
    if (!asked.scenario.empty()) {
      refuse(source, "/scenario", asked.scenario, "one event alone cannot be logged", "no --log");
    }
    const bool known =
        std::ranges::count(study_.fidelity, asked.spacing, &designs::FidelityLevel::spacing) > 0;
    if (!known) {
      refuse(source, "/spacing_mm", 1000.0 * asked.spacing,
             "is no spacing of the study, so it cannot be logged",
             "a spacing of fidelity/spacings_m, or no --log");
    }
  }

  bool answered_from_log(const Json& id, const study::StreamedDesign& asked) {
    if (!folder_) return false;
    const std::scoped_lock lock(mutex_);
    const auto* known = folder_->log().find(asked.design, asked.spacing);
    if (known != nullptr) print(id, *known, true);
    return known != nullptr;
  }

  /// From a thread of the stream.
  void answer(const study::StreamedDesign& asked, const study::DesignRun& run) {
    const std::scoped_lock lock(mutex_);
    const Json id = ids_.at(asked.number);
    ids_.erase(asked.number);
    if (!folder_) {
      print(id, study::external_record(run, session_.program), false);
      return;
    }
    print(id, study::log_external(*folder_, study_, run, session_.program, !options_.no_report),
          false);
  }

  /// With mutex_ held.
  void print_line(const Json& json) {
    session_.out->print("{}\n", json.dump(-1, ' ', false, Json::error_handler_t::replace));
  }

  /// With mutex_ held.
  void print(const Json& id, const records::EvaluationRecord& record, bool from_log) {
    Json json = records::to_json(record);
    json["id"] = id;
    if (folder_) {
      json["log_id"] = record.id;
      json["from_log"] = from_log;
    }
    print_line(json);
  }

  void print_error(const Json& id, const InputError& error) {
    Json json;
    json["id"] = id;
    json["status"] = "error";
    json["reason"] = error.what();
    json["issues"] = Json::array();
    for (const InputIssue& issue : error.issues()) {
      json["issues"].push_back({{"file", issue.file},
                                {"pointer", issue.pointer},
                                {"value", issue.value},
                                {"problem", issue.problem},
                                {"allowed", issue.allowed}});
    }
    const std::scoped_lock lock(mutex_);
    print_line(json);
  }

  const Session& session_;
  const EvaluateOptions& options_;
  designs::StudySpec study_;
  std::mutex mutex_;  // guards the log, the ids and standard output
  std::optional<records::StudyFolder> folder_;
  std::map<std::size_t, Json> ids_;  // by the line's number
  study::DesignStream designs_;      // last: its threads use the others
};

}  // namespace

int evaluate_stream(const Session& session, const EvaluateOptions& options) {
  return Stream(session, options).run();
}

}  // namespace parapet::cli
