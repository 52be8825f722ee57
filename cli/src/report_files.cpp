#include "report_files.hpp"

#include "parapet/designs/error.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/output_folder.hpp"

namespace parapet::cli {

void write_report(const Session& session, const std::filesystem::path& folder,
                  reports::PageOptions options) {
  options.program = session.program;
  try {
    reports::write_report(folder, reports::folder_report(folder, options));
    session.log->info("page: open {} in a browser", (folder / records::report_page).string());
  } catch (const designs::InputError& error) {
    session.log->warn("no page: {}", error.what());
  }
}

}  // namespace parapet::cli
