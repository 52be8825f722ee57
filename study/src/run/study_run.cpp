#include "parapet/study/study_run.hpp"

#include "output_writer.hpp"
#include "parapet/optimizer/optimize.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/study_folder.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/undisturbed.hpp"
#include "study_methods.hpp"

namespace parapet::study {
namespace {

/// The disk may be full, and then this does not work either: the exception itself says it all.
void try_to_say_failed(OutputWriter& writer, const std::string& why,
                       const records::StudyFolder& folder) {
  StudySummary summary;
  summary.state = StudyState::failed;
  summary.termination = optimizer::to_string(optimizer::Termination::failed);
  summary.message = why;
  try {
    writer.end(summary);
    folder.close();
  } catch (const records::FileError&) {
  }
}

}  // namespace

StudySummary run_study(const designs::StudySpec& asked, const StudyRunOptions& options) {
  designs::StudySpec study = asked;
  if (auto issues = method_issues(study); !issues.empty()) {
    throw designs::InputError(std::move(issues));
  }
  records::StudyFolder folder(options.folder, study, options.program,
                              {.mix_physics = options.mix_physics});
  folder.begin({.jobs = options.jobs, .max_evaluations = study.method.max_evaluations});
  if (options.hooks.on_message) {
    for (const std::string& note : folder.notes()) options.hooks.on_message(note);
  }
  if (options.undisturbed) {
    study.undisturbed =
        make_undisturbed(options.folder, study, options.program, options.jobs, options.hooks);
  }
  OutputWriter writer(study, folder, options.hooks);
  writer.record_added();
  Hooks hooks = options.hooks;
  hooks.on_evaluated = [&](const records::EvaluationRecord& record, bool from_log) {
    if (!from_log) writer.record_added();
    if (options.hooks.on_evaluated) options.hooks.on_evaluated(record, from_log);
  };
  const auto service = options.service(options.jobs, service_hooks(hooks));
  const StudyContext context{.study = study,
                             .folder = folder,
                             .program = options.program,
                             .service = *service,
                             .hooks = hooks};
  try {
    StudySummary summary = search_study(context, writer);
    folder.close();
    return summary;
  } catch (const std::exception& error) {
    writer.detach();
    try_to_say_failed(writer, error.what(), folder);
    throw;
  }
}

}  // namespace parapet::study
