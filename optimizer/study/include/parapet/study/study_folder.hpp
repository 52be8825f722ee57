/// A study on disk: study.json, evaluations.jsonl, evaluations/ID.json and summary.json.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/reports/evaluation_log.hpp"
#include "parapet/reports/provenance.hpp"
#include "parapet/study/folder_lock.hpp"

namespace parapet::study {

/// The folder of one study, locked for writing while this lives.
class StudyFolder {
 public:
  /// Creates the folder, or opens it when it belongs to the same study (see study_hash).
  /// @param patience how long to wait for another writer
  /// @throws designs::InputError when it belongs to another study, is being written to, or its log
  ///         is damaged before its last line. Nothing is changed then.
  /// @throws reports::FileError
  StudyFolder(std::filesystem::path folder, const designs::StudySpec& study,
              const reports::ProgramInfo& program, std::chrono::milliseconds patience = {});

  const reports::EvaluationLog& log() const { return log_; }

  /// Writes evaluations/ID.json, then the log's line; both are on disk when it returns.
  /// @throws reports::FileError
  void store(const reports::EvaluationRecord& record, const designs::Json& report);

  /// Replaces summary.json.
  void write_summary(const designs::Json& summary) const;

  const std::filesystem::path& path() const { return folder_; }

  /// Sentences worth telling the user: a repaired log, another program version.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::filesystem::path folder_;
  std::vector<std::string> notes_;
  FolderLock lock_;
  reports::EvaluationLog log_;
};

}  // namespace parapet::study
