/// evaluations.jsonl: one line per evaluated design, on disk before anybody learns the value.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::records {

/// The value of one objective: its statistic over the scenarios.
struct ObjectiveRecord {
  std::string metric;  ///< the objective's name; by default its metric or expression
  designs::Goal goal = designs::Goal::maximize;
  double weight = 1.0;
  std::optional<double> value;
  bool absent = false;  ///< the metric had no value (in at least one scenario)
};

/// How one constraint stands. `margin` is the distance to the nearest limit, negative outside; in
/// the unit of the value, empty where there is no value.
struct ConstraintRecord {
  std::string name;
  std::optional<double> value;
  std::optional<double> lower, upper;
  bool satisfied = false;
  std::optional<double> margin;
};

/// A design under one scenario.
struct ScenarioRecord {
  std::string name;
  double weight = 1.0;
  bool ok = false;
  std::string reason;  ///< why it failed
  std::vector<solver::Metric> metrics;
  double wall_time = 0.0;       ///< [s]
  double cpu_time = 0.0;        ///< [s]
  double particle_steps = 0.0;  ///< particles released times time steps
  std::string stop_reason;      ///< why its simulation ended; empty: not known
};

/// One evaluated design, as it stands in the log. Numbers keep every bit through the file.
struct EvaluationRecord {
  std::string id;  ///< "0001", ...
  /// "start", "initial", "search" and "confirm" (of a search), "sample" (of a design of
  /// experiments), or "external" (parapet evaluate)
  std::string stage;
  designs::Design design;
  std::map<std::string, std::string> options;  ///< choice -> option taken; empty without choices
  bool ok = false;
  std::string reason;                   ///< why it failed
  std::vector<solver::Metric> metrics;  ///< with scenarios: weighted means
  std::vector<ObjectiveRecord> objectives;
  std::optional<double> objective_scalar;  ///< to be minimised; empty when failed
  std::vector<ConstraintRecord> constraints;
  bool feasible = false;
  double spacing = 0.0;                   ///< particle spacing [m]
  double wall_time = 0.0;                 ///< sum over the scenarios [s]
  std::vector<ScenarioRecord> scenarios;  ///< empty: the base event alone
  double cpu_time = 0.0;                  ///< sum over the scenarios [s]; 0: not known
  double particle_steps = 0.0;            ///< sum over the scenarios; 0: not known
  std::string stop_reason;                ///< of the base event; empty: scenarios, or not known
};

/// A scenario as the log holds it.
designs::Json to_json(const ScenarioRecord& scenario);

/// A design as a line of the log holds it.
designs::Json to_json(const EvaluationRecord& record);

/// @throws std::runtime_error or nlohmann::json::exception saying what is wrong with the record.
EvaluationRecord record_from_json(const designs::Json& json);

/// The inverse of to_json for a scenario; throws the same.
ScenarioRecord scenario_from_json(const designs::Json& json);

/// What a log holds.
struct LogContent {
  std::vector<EvaluationRecord> records;
  bool incomplete_last_line = false;  ///< it is half written and not among the records
  bool ends_with_line = true;         ///< the last record has its line end
  std::size_t whole_bytes = 0;        ///< of the file, up to the end of the last record
};

/// Reads a log that another process may be writing to; changes nothing.
/// @throws designs::InputError naming the line when one before the last is damaged.
/// @throws FileError
LogContent read_evaluation_log(const std::filesystem::path& file);

/// The log of a study, open for appending. One writer at a time (see FolderLock).
class EvaluationLog {
 public:
  /// Opens or creates the log and reads what it holds. A last line that a crash left half-written
  /// is moved to `<file>.damaged` and cut off; `repair_note` says so.
  /// @throws designs::InputError naming the line when an earlier one is damaged.
  /// @throws FileError
  explicit EvaluationLog(std::filesystem::path file);
  ~EvaluationLog();
  EvaluationLog(const EvaluationLog&) = delete;
  EvaluationLog& operator=(const EvaluationLog&) = delete;

  /// Appends one line and syncs it to disk before it returns.
  /// @throws FileError; the log is then cut back to what it was.
  void append(const EvaluationRecord& record);

  /// Every record, in the order of the file.
  const std::vector<EvaluationRecord>& records() const { return records_; }

  /// The record of exactly this design (the same bits) at this particle spacing [m], or nullptr.
  const EvaluationRecord* find(const designs::Design& design, double spacing) const;

  /// Whether a record has this id.
  bool has_id(const std::string& id) const;

  /// What was repaired when the log was opened; empty if nothing was.
  const std::string& repair_note() const { return repair_note_; }

 private:
  void read_and_repair();
  void set_damage_aside(const std::string& content, std::size_t good_size);

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::vector<EvaluationRecord> records_;
  std::map<std::pair<designs::Design, double>, std::size_t> by_design_;
  std::map<std::string, std::size_t> by_id_;
  std::string repair_note_;
};

/// "0001" for 1.
std::string evaluation_id(int number);

}  // namespace parapet::records
