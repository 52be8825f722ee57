/// report.html: one page with everything that a folder of results holds, for any browser, offline.
/// docs/page.md describes it.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "parapet/records/program_info.hpp"
#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// How a page is made.
struct PageOptions {
  records::ProgramInfo program;
  /// Designs or rows whose recordings and series come first, where not all have room.
  std::vector<std::string> first = {};
  bool live = false;       ///< the page is served, and asks its server what is new
  study::PickRule rule{};  ///< of a study
};

/// Most bytes of recordings in a page, before they are written as text.
constexpr std::size_t most_recorded_bytes = 9'000'000;

/// What is made of a folder of results for people and for other programs.
struct FolderReport {
  std::string page;
  std::string designs_csv;  ///< of a study: every design, a row each (docs/formats.md); else empty
};

/// The report of a study.
FolderReport study_report(const study::LoadedStudy& study, const Recommendation& recommendation,
                          const PageOptions& options);

/// The report of a folder, whatever it holds: a study, a simulation, a sweep or a validation.
/// Nothing is simulated or written.
/// @throws designs::InputError when it holds none of these, or what it holds is damaged
FolderReport folder_report(const std::filesystem::path& folder, const PageOptions& options);

/// The page of several studies: one front of all their designs by the objectives that they share,
/// and what makes them hard to compare.
/// @throws designs::InputError when a folder holds no study, or they share no objective
std::string studies_page(const std::vector<std::filesystem::path>& folders,
                         const PageOptions& options);

/// Writes folder/report.html, and of a study designs.csv, and enters them into the folder's
/// checksums, where there are some.
/// @throws records::FileError
void write_report(const std::filesystem::path& folder, const FolderReport& report);

}  // namespace parapet::reports
