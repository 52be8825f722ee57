/// The verification and validation suite: cases with an exact, a measured or a published answer.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "parapet/validation/scorecard.hpp"

namespace parapet::validation {

struct CaseInfo {
  std::string name;   ///< as the command line takes it
  std::string title;  ///< in words
};

/// All cases in the order of the report.
std::vector<CaseInfo> list_cases();

struct SuiteOptions {
  std::filesystem::path folder;   ///< takes NAME.json and the figures of each case
  std::vector<std::string> only;  ///< names of cases; empty for all
  bool full = true;               ///< false: coarse versions of seconds each
  int jobs = 1;                   ///< flows simulated side by side; the answers do not depend on it
  std::function<bool()> cancelled;                                ///< asked between time steps
  std::function<void(const std::string& name)> on_start;          ///< a case begins
  std::function<void(double done, double total)> on_progress;     ///< rough cost
  std::function<void(const Scorecard&, double seconds)> on_case;  ///< a case has ended
};

struct SuiteOutcome {
  std::vector<Scorecard> cards;         ///< of the cases that have ended, in the report's order
  std::vector<std::string> unfinished;  ///< names of those that were cancelled
};

/// Runs the cases and writes each scorecard as soon as it is there. The callbacks may come from
/// several threads, one at a time.
/// @throws std::invalid_argument for a name that no case has, naming those there are.
/// @throws records::FileError when the folder cannot be written.
SuiteOutcome run_suite(const SuiteOptions& options);

/// The scorecards as a table for a terminal.
std::string scorecard_text(const std::vector<Scorecard>& cards);

struct Page {
  std::string file;  ///< name within the folder
  std::string text;  ///< Markdown
};

/// The pages of the suite, made of the scorecards in `folder` and the texts that the library holds:
/// README.md, and CASE.md for each case that has a scorecard. Every figure comes from the
/// scorecards.
/// @throws std::invalid_argument where a scorecard cannot be read or a page asks for a figure that
///         no scorecard has.
std::vector<Page> pages(const std::filesystem::path& folder);

}  // namespace parapet::validation
