#include "parapet/study/sweep_run.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/checksum_list.hpp"
#include "parapet/records/file_name.hpp"
#include "parapet/records/folder_lock.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/records/sweep_row_file.hpp"
#include "parapet/study/sweep_result.hpp"
#include "parapet/study/thread_count.hpp"
#include "simulate_in_order.hpp"

namespace parapet::study {
namespace {

using RowResults = std::map<std::string, records::SweepRowResult>;

void check_ids(const designs::SweepSpec& sweep, const std::vector<std::string>& only) {
  std::string known;
  for (const auto& row : sweep.rows) known += (known.empty() ? "" : ", ") + row.id;
  std::vector<designs::InputIssue> issues;
  for (const std::string& id : only) {
    const bool found = std::any_of(sweep.rows.begin(), sweep.rows.end(),
                                   [&](const auto& row) { return row.id == id; });
    if (found) continue;
    issues.push_back({.file = "--only",
                      .pointer = "",
                      .value = id,
                      .problem = "the sweep " + sweep.name + " has no row of this id",
                      .allowed = known});
  }
  if (!issues.empty()) throw designs::InputError(std::move(issues));
}

/// A guess at the work in a row, only to begin with the longest: particle steps, and more barriers
/// hold more debris in the channel for longer.
double expected_work(const designs::SweepRow& row) {
  const auto& scene = row.spec.scene;
  const double dx = row.spec.numerics.spacing;
  const double particles = scene.reservoir_length * scene.reservoir_height / (dx * dx);
  double heights = 0.0;
  for (const auto& barrier : scene.barriers) heights += barrier.height;
  return particles * row.spec.run.stop_time / dx *
         (1.0 + static_cast<double>(scene.barriers.size()) + heights / scene.domain_length);
}

class SweepRun {
 public:
  SweepRun(const designs::SweepSpec& sweep, const SweepRunOptions& options)
      : sweep_(sweep), options_(options), rows_folder_(options.folder / "rows") {}

  SweepOutcome run() {
    check_ids(sweep_, options_.only);
    records::open_output_folder(options_.folder, records::FolderKind::sweep);
    const records::FolderLock lock(options_.folder);
    refuse_other_rows();
    find_finished();
    records::take_output_folder(options_.folder, records::FolderKind::sweep);
    records::make_folder(rows_folder_);
    records::ChecksumList checksums(options_.folder);
    for (const std::string& name : checksums.damaged()) {
      if (options_.hooks.on_message) options_.hooks.on_message(checksums.note(name));
    }
    checksums.begin();
    write_table();
    simulate_rows();
    checksums.write();
    SweepOutcome outcome;
    outcome.interrupted = cancelled_;
    for (const designs::SweepRow& row : sweep_.rows) {
      if (!wanted(row)) continue;
      const auto found = finished_.find(row.id);
      if (found != finished_.end())
        outcome.rows.push_back(found->second);
      else
        outcome.interrupted = true;
    }
    return outcome;
  }

 private:
  bool wanted(const designs::SweepRow& row) const {
    return options_.only.empty() ||
           std::find(options_.only.begin(), options_.only.end(), row.id) != options_.only.end();
  }

  bool stopped() const {
    return cancelled_ || (options_.hooks.cancelled && options_.hooks.cancelled());
  }

  /// A row that this sweep does not have would stand beside its results as if it had.
  void refuse_other_rows() const {
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(rows_folder_, none)) {
      const std::string id = entry.path().stem().string();
      const bool ours = std::any_of(sweep_.rows.begin(), sweep_.rows.end(),
                                    [&](const auto& row) { return row.id == id; });
      if (ours || entry.path().extension() != ".json") continue;
      throw designs::InputError(
          {{.file = entry.path().string(),
            .pointer = "",
            .value = "",
            .problem = "is a row that the sweep " + sweep_.name + " does not have",
            .allowed = "rows of this sweep; remove the file, or choose another "
                       "folder with --out"}});
    }
  }

  void find_finished() {
    for (const designs::SweepRow& row : sweep_.rows) {
      if (auto known = records::read_finished_row(rows_folder_, row, options_.program)) {
        if (wanted(row) && options_.on_row) options_.on_row(*known, true);
        finished_.emplace(row.id, *std::move(known));
      } else if (wanted(row)) {
        waiting_.push_back(&row);
      }
    }
    std::stable_sort(waiting_.begin(), waiting_.end(), [](const auto* a, const auto* b) {
      return expected_work(*a) > expected_work(*b);
    });
  }

  void simulate_rows() {
    if (waiting_.empty()) return;
    const auto service = options_.service(options_.jobs, service_hooks(options_.hooks));
    const int threads = threads_each(waiting_.size(), service->places());
    simulate_in_order(
        *service, waiting_.size(),
        [&](std::size_t k) {
          SimulationTask task = task_from_case(waiting_[k]->spec, waiting_[k]->id);
          task.threads = threads;
          return std::optional(std::move(task));
        },
        [this](std::size_t k, const records::Simulation& simulation) {
          keep(*waiting_[k], simulation);
        },
        [this] { return stopped(); });
  }

  void keep(const designs::SweepRow& row, const records::Simulation& simulation) {
    if (simulation.cancelled) {
      cancelled_ = true;
      return;
    }
    records::write_finished_row(rows_folder_, row, simulation, options_.program);
    const auto [place, added] =
        finished_.insert_or_assign(row.id, records::make_sweep_row_result(row, simulation));
    write_table();
    if (options_.on_row) options_.on_row(place->second, false);
  }

  /// All finished rows, in the sweep's order.
  void write_table() const {
    std::vector<records::SweepRowResult> rows;
    for (const designs::SweepRow& row : sweep_.rows) {
      if (const auto found = finished_.find(row.id); found != finished_.end()) {
        rows.push_back(found->second);
      }
    }
    const designs::Json provenance =
        records::provenance_json(options_.program, designs::spec_hash(sweep_.resolved));
    records::write_file_atomically(
        options_.folder / sweep_table_file(sweep_),
        records::json_text(sweep_json(sweep_.name, sweep_.source,
                                      sweep_.rows.front().spec.numerics.spacing, rows,
                                      provenance)));
  }

  const designs::SweepSpec& sweep_;
  const SweepRunOptions& options_;
  std::filesystem::path rows_folder_;
  std::vector<const designs::SweepRow*> waiting_;
  RowResults finished_;
  bool cancelled_ = false;
};

}  // namespace

std::string sweep_table_file(const designs::SweepSpec& sweep) {
  return records::file_name(sweep.name) + ".json";
}

SweepOutcome run_sweep(const designs::SweepSpec& sweep, const SweepRunOptions& options) {
  return SweepRun(sweep, options).run();
}

}  // namespace parapet::study
