#include "flow_records.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interrupt.hpp"
#include "parapet/records/checksum_list.hpp"
#include "parapet/records/folder_lock.hpp"
#include "run_monitor.hpp"

namespace parapet::cli {

bool record_and_say(const Session& session, const std::filesystem::path& folder,
                    std::vector<study::FlowToRecord> flows, int jobs, bool only_these) {
  const records::FolderLock lock(folder);
  RunMonitor monitor(session, static_cast<int>(flows.size()), "recordings");
  std::set<std::string> files;
  for (const study::FlowToRecord& flow : flows) {
    files.insert(std::filesystem::relative(study::recording_file(folder, flow.name), folder));
  }
  study::Hooks hooks;
  hooks.cancelled = interrupted;
  hooks.on_simulation = [&](const std::string& id, const solver::Progress& progress) {
    monitor.running(id, progress);
  };
  hooks.on_simulation_ended = [&](const std::string& id) { monitor.ended(id, false); };
  const study::RecordOutcome outcome =
      study::record_flows(folder, std::move(flows), jobs, hooks, only_these);
  if (outcome.recorded > 0) {
    session.log->info("{} flow{} recorded in {}", outcome.recorded,
                      outcome.recorded == 1 ? "" : "s", (folder / "recordings").string());
  }
  if (!outcome.different.empty()) {
    session.log->warn(
        "recorded by another program than the one that simulated them, with other numbers: {}",
        fmt::join(outcome.different, ", "));
  }
  if (!outcome.failed.empty()) {
    session.log->warn("not recorded, for the simulation failed: {}",
                      fmt::join(outcome.failed, ", "));
  }
  if (outcome.recorded > 0 && !outcome.cancelled) records::update_checksums(folder, files);
  return !outcome.cancelled;
}

}  // namespace parapet::cli
