/// Options that several verbs share.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

namespace parapet::cli {

/// Number of cores that this process may use, at least 1.
int core_count();

struct CommonOptions {
  std::string out;                   ///< empty: the default folder
  std::optional<double> spacing_mm;  ///< overrides the spec's particle spacing
  int jobs = core_count();
  bool mix_revisions = false;  ///< whether to continue a study of another physics number
};

void add_out(CLI::App& app, CommonOptions& options, const std::string& default_text);
void add_spacing(CLI::App& app, CommonOptions& options);
void add_mix_revisions(CLI::App& app, CommonOptions& options);
void add_jobs(CLI::App& app, CommonOptions& options, const std::string& what);

/// --out, or runs/NAME with the verb and an overridden spacing: the same command finds the same
/// folder again.
std::filesystem::path output_folder(const CommonOptions& options, const std::string& name,
                                    const std::string& verb);

}  // namespace parapet::cli
