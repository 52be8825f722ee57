/// The page at the end of a verb.
#pragma once

#include <filesystem>
#include <vector>

#include "parapet/reports/page.hpp"
#include "session.hpp"

namespace parapet::cli {

/// Writes the folder's report.html and says where. What is wrong with the folder's content is a
/// warning: the results themselves are there.
/// @throws records::FileError when the page cannot be written, such as on a full disk
void write_report(const Session& session, const std::filesystem::path& folder,
                  reports::PageOptions options = {});

}  // namespace parapet::cli
