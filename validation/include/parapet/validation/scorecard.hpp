/// What a verification or validation case found: measured values beside their limits.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace parapet::validation {

enum class Verdict {
  met,      ///< within its limits
  fitted,   ///< within them, by a reading that was chosen after results were seen
  missed,   ///< outside them; stays visible
  measured  ///< a figure without a limit
};

const char* to_string(Verdict verdict);

/// One row of the scorecard.
struct Measure {
  std::string key = {};              ///< unique within the case, for example "error_40"
  std::string what = {};             ///< in words, with the spacing where it matters
  double value = 0.0;                ///< measured
  std::string unit = {};             ///< "%", "s", "m"; empty for a pure number
  std::optional<double> lower = {};  ///< smallest value allowed
  std::optional<double> upper = {};  ///< largest value allowed
  std::string reason = {};           ///< of the limit
  std::string explanation = {};      ///< why a limit is missed, where that is understood
  bool fitted = false;               ///< the reading was chosen after results were seen

  Verdict verdict() const;
};

/// The scorecard of one case.
struct Scorecard {
  std::string name;     ///< of the case, for example "poiseuille"
  std::string title;    ///< in words
  bool full = true;     ///< the full suite, not the quick version of continuous integration
  std::string failure;  ///< why the case could not be carried out; empty when it was
  std::vector<Measure> measures;
  std::vector<std::string> figures;  ///< file names beside the scorecard

  /// Number of measures with this verdict.
  int count(Verdict verdict) const;
  /// @returns nullptr where there is none
  const Measure* find(const std::string& key) const;
};

/// The value with its unit in four significant digits: "0.321 %", "1.05 s".
std::string value_text(double value, const std::string& unit);

/// The limits in words: "at most 1 %", "0.95 to 1.05", "at least 1.5"; empty without limits.
std::string limit_text(const Measure& measure);

nlohmann::ordered_json to_json(const Scorecard& card);

/// @throws std::invalid_argument naming the key where the text is no scorecard.
Scorecard scorecard_from_json(const nlohmann::ordered_json& json);

}  // namespace parapet::validation
