/// The recommended design simulated again, and designs very near to it: how far does the answer
/// move, and does it still meet every constraint?
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/study/confirmation.hpp"
#include "parapet/study/hooks.hpp"
#include "parapet/study/local_service.hpp"
#include "parapet/study/pick_rule.hpp"

namespace parapet::study {

/// By how much a near design differs in each continuous variable, as a share of its range.
constexpr double near_share = 0.005;

/// What is simulated again, and how.
struct ConfirmOptions {
  std::filesystem::path folder;   ///< of the study
  std::optional<double> spacing;  ///< a further particle spacing, usually a finer one [m]
  int repeats = 2;                ///< near designs
  int jobs = 1;                   ///< simulations side by side
  records::ProgramInfo program;
  Hooks hooks;
  /// A design's confirmation begins: so many runs, each of every event.
  std::function<void(const Pick& pick, std::size_t runs)> on_pick;
  ServiceFactory service = local_service();  ///< who simulates
};

/// What became of it.
struct ConfirmOutcome {
  bool cancelled = false;
  std::string refusal;  ///< why nothing was confirmed: the study is being written to
  int simulated = 0;    ///< runs that were not in confirmations.jsonl before
  std::optional<std::string> confirmed;  ///< id of the first design that held
  std::vector<std::string> refuted;      ///< ids that did not, in order
};

/// Up to `count` designs that differ from a pick by near_share of the range in every continuous
/// variable that it has, up or down by a seeded draw; at a bound, inwards. Choices and integers
/// stay. Fewer where constraints on formulas forbid the others, or none without such a variable.
std::vector<designs::Design> near_designs(const designs::StudySpec& study,
                                          const designs::Design& pick, int count);

/// Confirms the first pick that holds, of at most most_confirmed_designs: at the study's
/// finest spacing when it was not observed there, at options.spacing, and the near designs at the
/// finest. Each run is scored over all scenarios and appended to confirmations.jsonl (lines as in
/// evaluations.jsonl) as soon as it has ended; runs that are there are not simulated again.
/// @throws designs::InputError for a damaged confirmations.jsonl, records::FileError
ConfirmOutcome confirm_picks(const designs::StudySpec& study, const std::vector<Pick>& picks,
                             const ConfirmOptions& options);

}  // namespace parapet::study
