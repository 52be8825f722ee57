/// The undisturbed flow of a study's event, simulated once and kept as approach.json in its folder.
#pragma once

#include <filesystem>
#include <memory>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/program_info.hpp"
#include "parapet/study/hooks.hpp"

namespace parapet::study {

/// The flow in a folder's approach.json, for StudySpec::undisturbed; nullptr where there is none,
/// or where it is of another event.
std::shared_ptr<const designs::UndisturbedFlow> read_undisturbed(
    const std::filesystem::path& folder, const designs::StudySpec& study);

/// The same; where there is none it is simulated at the finest spacing, with up to `threads`
/// threads, and written. nullptr for a study of scenarios, whose events are others, for a base case
/// without barriers, and for a run that failed or was cancelled.
/// @throws records::FileError
std::shared_ptr<const designs::UndisturbedFlow> make_undisturbed(
    const std::filesystem::path& folder, const designs::StudySpec& study,
    const records::ProgramInfo& program, int threads, const Hooks& hooks);

}  // namespace parapet::study
