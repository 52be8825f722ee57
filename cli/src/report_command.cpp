#include <algorithm>
#include <memory>

#include "common_options.hpp"
#include "flow_records.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/reports/page.hpp"
#include "parapet/study/loaded_study.hpp"
#include "parapet/study/record_flows.hpp"
#include "session.hpp"

namespace parapet::cli {
namespace {

struct ReportOptions : CommonOptions {
  std::vector<std::filesystem::path> folders;
  std::vector<std::string> record, show;
};

/// The designs that are to be recorded: ids, "front" or "all".
std::vector<study::FlowToRecord> flows_asked_for(const study::LoadedStudy& study,
                                                 const std::vector<std::string>& names) {
  designs::StudySpec spec = study.spec;
  std::vector<records::EvaluationRecord> chosen;
  for (const std::string& name : names) {
    if (name == "front" || name == "all") {
      spec.recordings = name == "all" ? designs::Recordings::all : designs::Recordings::front;
      for (auto& record : study::designs_to_record(spec, study.designs)) {
        chosen.push_back(std::move(record));
      }
      continue;
    }
    const auto found = std::ranges::find(study.designs, name, &records::EvaluationRecord::id);
    if (found == study.designs.end()) {
      throw designs::InputError({{.file = "--record",
                                  .pointer = "",
                                  .value = name,
                                  .problem = "is no design of this study",
                                  .allowed = "ids of evaluations.jsonl, front, or all"}});
    }
    chosen.push_back(*found);
  }
  std::vector<study::FlowToRecord> flows;
  for (const records::EvaluationRecord& record : chosen) {
    flows.push_back(study::flow_of_design(study.spec, record));
  }
  return flows;
}

/// One page of several studies; it belongs to none of their folders.
int report_studies(const Session& session, const ReportOptions& options) {
  for (const std::filesystem::path& folder : options.folders) records::refuse_links(folder);
  if (!options.record.empty() || !options.show.empty()) {
    throw designs::InputError({{.file = options.record.empty() ? "--show" : "--record",
                                .pointer = "",
                                .value = "",
                                .problem = "goes with one folder alone",
                                .allowed = "parapet report DIR for each study first"}});
  }
  const std::filesystem::path file = options.out.empty() ? "studies.html" : options.out;
  records::write_file_atomically(
      file, reports::studies_page(options.folders, {.program = session.program}));
  session.out->print("page: {}\n", file.string());
  return exit_done;
}

int report_command(const Session& session, const ReportOptions& options) {
  if (options.folders.size() > 1) return report_studies(session, options);
  const std::filesystem::path& folder = options.folders.front();
  records::refuse_links(folder);
  if (!options.record.empty()) {
    const study::LoadedStudy study = study::load_study_folder(folder);
    if (!record_and_say(session, folder, flows_asked_for(study, options.record), options.jobs,
                        false)) {
      return exit_interrupted;
    }
  }
  reports::PageOptions page{.program = session.program, .first = options.show};
  page.first.insert(page.first.end(), options.record.begin(), options.record.end());
  const reports::FolderReport report = reports::folder_report(folder, page);
  if (options.out.empty()) {
    reports::write_report(folder, report);
  } else {
    records::write_file_atomically(options.out, report.page);
  }
  const std::filesystem::path file =
      options.out.empty() ? folder / records::report_page : std::filesystem::path(options.out);
  session.out->print("page: {}\n", file.string());
  return exit_done;
}

}  // namespace

void add_report(CLI::App& app, Session& session) {
  CLI::App* verb =
      app.add_subcommand("report", "Write the page of results: one file for any browser, offline");
  auto options = std::make_shared<ReportOptions>();
  verb->add_option("DIR", options->folders,
                   "Folder that simulate, table3, optimize or validate has written; several "
                   "studies come into one front")
      ->required();
  verb->add_option("--out", options->out,
                   "The file (default: DIR/report.html; of several studies studies.html)")
      ->type_name("FILE");
  verb->add_option(
          "--record", options->record,
          "Of a study: first simulate these designs once more and record their flows; ids, "
          "front, or all")
      ->delimiter(',')
      ->type_name("ID,ID");
  verb->add_option(
          "--show", options->show,
          "Designs or rows whose recordings and series are in the page before others, where "
          "not all have room")
      ->delimiter(',')
      ->type_name("ID,ID");
  add_jobs(*verb, *options, "Simulations side by side");
  verb->footer(
      R"(The page holds everything: it asks for nothing from anywhere, and can be sent or kept. simulate,
table3, optimize and recommend write it at their end.

Examples:
  parapet report runs/quickstart-optimize
  parapet report runs/quickstart-optimize --record front
  parapet report runs/low runs/high --out compare.html
  parapet report docs/validation --out validation.html)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return report_command(session, *options); };
  });
}

}  // namespace parapet::cli
