/// report.html: one page with everything that a folder of results holds, for any browser, offline.
/// docs/page.md describes it.
#pragma once

#include <filesystem>
#include <set>
#include <string>

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
constexpr std::size_t most_recorded_bytes = 9'500'000;

/// The page of a study.
std::string study_page(const study::LoadedStudy& study, const Recommendation& recommendation,
                       const PageOptions& options);

/// The page of a folder, whatever it holds: a study, a simulation, a sweep or a validation. Nothing
/// is simulated or written.
/// @throws designs::InputError when it holds none of these, or what it holds is damaged
std::string folder_page(const std::filesystem::path& folder, const PageOptions& options);

/// Writes folder/report.html and enters it into the folder's checksums, where there are some.
/// @throws as folder_page, and records::FileError
void write_page(const std::filesystem::path& folder, const std::string& page);

}  // namespace parapet::reports
