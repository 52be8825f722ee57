/// Whose folder: results go only where nobody else's files are.
#pragma once

#include <filesystem>
#include <string>

namespace parapet::records {

/// What a folder holds.
enum class FolderKind { simulation, sweep, study, advice, validation };

/// Makes the folder, or refuses one that is not ours. Ours is a folder that is empty, or that says
/// by the file `.parapet` or by the format of its results that Parapet wrote results of this kind
/// there. Links in the path are followed; a link inside the folder is refused.
/// @throws designs::InputError naming what stands there; nothing is changed then
/// @throws FileError
void open_output_folder(const std::filesystem::path& folder, FolderKind kind);

/// Marks a folder as ours and removes files that a crash left half written. Nobody else may write
/// into it meanwhile: the caller holds its FolderLock, or has just made it.
/// @throws FileError
void take_output_folder(const std::filesystem::path& folder, FolderKind kind);

/// Refuses links in a folder of results and in the folders of results inside it.
/// @throws designs::InputError naming the first one
void refuse_links(const std::filesystem::path& folder);

/// Where `simulate` puts the recording of its run.
constexpr const char* simulation_recording = "recording.flow";

/// The page of a folder.
constexpr const char* report_page = "report.html";

/// The table of a study's designs beside it.
constexpr const char* designs_table = "designs.csv";

/// Removes what was made of a study or sweep that now goes on: its page, its table
/// and its recommendation.
/// @throws FileError
void remove_earlier_advice(const std::filesystem::path& folder);

/// Removes what an earlier simulation left in its folder: result, series, picture, recording, page
/// and frames.
/// @throws FileError
void remove_earlier_simulation(const std::filesystem::path& folder);

}  // namespace parapet::records
