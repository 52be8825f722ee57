/// evaluations.jsonl: one line per evaluated design, on disk before anybody learns the value.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
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

/// Value of one of the study's terms.
struct TermRecord {
  std::string name;
  std::optional<double> value;  ///< with scenarios: weighted mean; empty: it has none
};

/// How one constraint stands. `margin` is the distance to the nearest limit, negative outside; in
/// the unit of the value, empty where there is no value.
struct ConstraintRecord {
  std::string name;
  std::optional<double> value;
  std::optional<double> lower, upper;
  bool satisfied = false;
  std::optional<double> margin;
  /// How far beyond a limit still counted as satisfied, in the unit of the value; empty: not known.
  std::optional<double> tolerance = {};
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
  std::string case_hash;        ///< of what was simulated; empty: an impossible scene, or not known
  std::vector<solver::Warning> warnings;  ///< of its result
};

/// One evaluated design, as it stands in the log. Numbers keep every bit through the file.
struct EvaluationRecord {
  std::string id;  ///< "0001", ...
  /// "start", "initial", "search", "local", "explore", "confirm" (a search), "sample" (a design of
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
  std::string case_hash;                  ///< likewise, of what was simulated
  std::string program_version;            ///< of the program that evaluated it; empty: not known
  std::string git_revision;               ///< likewise
  int physics = 0;                        ///< its solver::physics_number; 0: not known
  std::vector<solver::Warning> warnings;  ///< of all its simulations, each key once, the worst
  std::vector<TermRecord> terms;          ///< of the study; empty where a simulation failed
};

/// A design that the constraints on formulas refused: it was not simulated.
struct RefusedDesign {
  std::string id;  ///< "refused-0001", ...
  designs::Design design;
  std::map<std::string, std::string> options;  ///< choice -> option taken; empty without choices
  std::string reason;                          ///< the constraints that it breaks
  std::vector<ConstraintRecord> constraints;   ///< on formulas
  std::string program_version;                 ///< of the program that refused it
  std::string git_revision;                    ///< likewise
};

/// Whether a text may be an id: it names files, so it can be no path.
bool is_id(const std::string& text);

/// A scenario as the log holds it.
designs::Json to_json(const ScenarioRecord& scenario);

/// A design as a line of the log holds it.
designs::Json to_json(const EvaluationRecord& record);

/// @throws std::runtime_error or nlohmann::json::exception saying what is wrong with the record.
EvaluationRecord record_from_json(const designs::Json& json);

/// Likewise for a refused design.
RefusedDesign refused_from_json(const designs::Json& json);

/// The inverse of to_json for a scenario; throws the same.
ScenarioRecord scenario_from_json(const designs::Json& json);

/// As a line of the log holds it, without its checksum.
designs::Json to_json(const RefusedDesign& refused);

/// The line of the log: to_json with its checksum, without a line end.
std::string log_line(const EvaluationRecord& record);

/// A line whose checksum is wrong, or which is no record.
struct DamagedLine {
  std::size_t number = 0;  ///< counted from 1
  std::string id;          ///< as far as it can be told
  std::string key;      ///< JSON pointer of the first value that differs from evaluations/ID.json,
                        ///< where that is there; else empty
  std::string problem;  ///< what is wrong, in words
  std::string text;     ///< the line itself
};

/// "log.jsonl: line 3 (design 0003, /feasible) is damaged: its checksum is wrong".
std::string to_string(const DamagedLine& line, const std::filesystem::path& file);

/// What a log holds.
struct LogContent {
  std::vector<EvaluationRecord> records;
  std::vector<RefusedDesign> refused;
  std::vector<DamagedLine> damaged;        ///< lines that are passed over
  std::size_t lines_without_checksum = 0;  ///< sound lines, as versions up to 0.1.0 wrote them
  bool incomplete_last_line = false;       ///< it is half written and not among the records
  bool ends_with_line = true;              ///< the last line has its end
  std::size_t whole_bytes = 0;             ///< of the file, up to the end of the last whole line
};

/// A sentence about lines without a checksum; empty where there are none.
std::string checksum_note(const LogContent& content, const std::filesystem::path& file);

/// Reads a log that another process may be writing to; changes nothing.
/// @throws designs::InputError naming the line when two sound lines have one id.
/// @throws FileError
LogContent read_evaluation_log(const std::filesystem::path& file);

/// The log of a study, open for appending. One writer at a time (see FolderLock).
class EvaluationLog {
 public:
  /// Opens or creates the log and reads what it holds. A last line that a crash left half-written,
  /// and damaged lines, are moved to `<file>.damaged`; `repairs` says so.
  /// @throws designs::InputError naming the line when two sound lines have one id.
  /// @throws FileError
  explicit EvaluationLog(std::filesystem::path file);
  ~EvaluationLog();
  EvaluationLog(const EvaluationLog&) = delete;
  EvaluationLog& operator=(const EvaluationLog&) = delete;

  /// Appends one line and syncs it to disk before it returns.
  /// @throws FileError; the log is then cut back to what it was.
  void append(const EvaluationRecord& record);

  /// The same for several, by one sync.
  void append(const std::vector<EvaluationRecord>& records);

  /// Appends a refused design, unless it stands there already. Not synced before the next record:
  /// it costs nothing to find it again.
  /// @throws FileError
  void append(RefusedDesign refused);

  /// Refused designs, in the order of the file.
  const std::vector<RefusedDesign>& refused() const { return refused_; }

  /// Lines that were damaged when the log was opened.
  const std::vector<DamagedLine>& damaged() const { return damaged_; }

  /// Every record, in the order of the file.
  const std::vector<EvaluationRecord>& records() const { return records_; }

  /// The record of exactly this design (the same bits) at this particle spacing [m], or nullptr.
  const EvaluationRecord* find(const designs::Design& design, double spacing) const;

  /// Whether a record has this id.
  bool has_id(const std::string& id) const;

  /// What was repaired when the log was opened, a sentence each.
  const std::vector<std::string>& repairs() const { return repairs_; }

  /// A sentence about lines without a checksum; empty where there are none.
  const std::string& checksum_note() const { return checksum_note_; }

 private:
  void open();
  void read_and_repair();
  void set_aside(const std::string& text) const;
  void cut_off_last_line(const std::string& content, std::size_t good_size);
  void remove_damaged_lines(const std::string& content);
  void append_line(const std::string& line, bool durable);

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::vector<EvaluationRecord> records_;
  std::map<std::pair<designs::Design, double>, std::size_t> by_design_;
  std::map<std::string, std::size_t> by_id_;
  std::vector<RefusedDesign> refused_;
  std::set<designs::Design> refused_designs_;
  std::vector<DamagedLine> damaged_;
  std::vector<std::string> repairs_;
  std::string checksum_note_;
};

/// "0001" for 1.
std::string evaluation_id(int number);

}  // namespace parapet::records
