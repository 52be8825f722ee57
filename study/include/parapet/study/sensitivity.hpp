/// Which variables the metrics of a study depend on, by its surrogates.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "parapet/designs/study_spec.hpp"
#include "parapet/study/sensitivity_file.hpp"

namespace parapet::study {

/// How much is spent on the sensitivities.
struct SensitivityOptions {
  int realisations = 24;   ///< posterior draws: the intervals hold what the surrogate does not know
  int anchors = 160;       ///< places of the box where a draw is fixed; between them it is smooth
  int base_points = 1024;  ///< of the Sobol' indices' sampling
  int bootstrap = 100;
  std::uint64_t seed = 1;
};

/// The content of surrogates.json for a study folder: the file's, when it is there and of this
/// study, else fitted to the log. Null when neither can be: too few designs (fewer than five) ended
/// well, or the log is missing. Nothing is written.
/// @param source set to "surrogates.json" or "evaluations.jsonl"
/// @throws designs::InputError for a log that is damaged before its last line
designs::Json study_surrogates(const designs::StudySpec& study, const std::filesystem::path& folder,
                               std::string& source);

/// For each modelled metric the Sobol' indices and the main effect of each variable, with 95 %
/// intervals, over the whole box of the variables' bounds (designs that a formula forbids
/// included). Coordinates of variables that do not exist under an option are drawn but have no
/// effect there; each integer and option has an equal share. Formulas of the design are left out:
/// they are known.
///
/// Draws of the posterior at `anchors` Sobol' points stand for realisations; elsewhere a
/// realisation is the surrogate's mean given its draw. Metrics are clipped to their possible
/// values.
/// @param surrogates format "parapet-surrogates/1"
/// @throws designs::InputError when that is damaged or not of this study
Sensitivity study_sensitivity(const designs::StudySpec& study, const designs::Json& surrogates,
                              const std::string& source, const SensitivityOptions& options = {});

}  // namespace parapet::study
