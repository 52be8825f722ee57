/// A tiny study, an undisturbed run of it to compare with, and means to disturb others.
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "parapet/designs/case_spec.hpp"
#include "program_runner.hpp"

namespace parapet::test {

class StudyTest : public ::testing::Test {
 protected:
  /// Runs the study undisturbed in DIR/calm.
  void SetUp() override;

  /// Arguments of the study in a folder.
  static std::vector<std::string> command(const std::string& out, const std::string& jobs = "2");

  /// Runs the study in `out` to its end and expects the undisturbed run's answer and log.
  void resume_and_compare(const std::string& out);

  /// Files of a study that are there, with their content.
  std::map<std::string, std::string> contents(const std::string& out) const;

  std::filesystem::path log_of(const std::string& out) const;
  designs::Json summary_of(const std::string& out) const;

  TemporaryFolder folder;
};

/// Lines of a log that are no refused designs.
std::size_t evaluations_in(const std::filesystem::path& log);

/// Lines by id, without measured times and checksums.
std::map<std::string, designs::Json> records_in(const std::filesystem::path& log);

}  // namespace parapet::test
