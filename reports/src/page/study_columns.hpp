/// A study as columns of a page: a list per quantity, in the order of its log.
#pragma once

#include <cstddef>
#include <string>

#include "page_html.hpp"
#include "parapet/reports/recommendation.hpp"
#include "run_blocks.hpp"

namespace parapet::reports {

/// Ids, kinds, variables, objectives, limits and metrics of every design.
designs::Json designs_json(const study::LoadedStudy& study, const Recommendation& advice);

/// The same as CSV: a row per design; docs/formats.md says which columns.
std::string designs_csv(const designs::Json& columns);

/// Adds every key of the study to the page.
void add_study_keys(designs::Json& page, const study::LoadedStudy& study);

/// How many designs of a study have room in a page.
struct StudyRoom {
  std::size_t drawn = 300;  ///< scenes take a millisecond each
  std::size_t with_series = 64;
};

/// Adds the runs of the designs, those of interest first; their names are prefix and id.
void add_study_runs(RunBlocks& runs, const study::LoadedStudy& study, const Recommendation& advice,
                    const PageOptions& options, const StudyRoom& room = {},
                    const std::string& prefix = "");

}  // namespace parapet::reports
