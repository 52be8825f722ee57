#include "common_options.hpp"

#include <algorithm>
#include <exception>
#include <thread>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/file_name.hpp"
#include "parapet/records/result_json.hpp"

namespace parapet::cli {
namespace {

/// What a folder of an earlier version says that it is about; empty where it says nothing.
std::string name_in(const std::filesystem::path& folder) {
  std::error_code ignored;
  const std::filesystem::path file = folder / "study.json";
  if (!std::filesystem::is_regular_file(file, ignored)) return "";
  try {
    const auto json = designs::Json::parse(records::read_own_file(file), nullptr, false);
    return json.is_object() ? json.value("name", "") : "";
  } catch (const std::exception&) {
    return "";
  }
}

}  // namespace

int core_count() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void add_out(CLI::App& app, CommonOptions& options, const std::string& default_text) {
  app.add_option("-o,--out", options.out, "Folder for the results (default: " + default_text + ")")
      ->type_name("DIR");
}

void add_spacing(CLI::App& app, CommonOptions& options) {
  app.add_option("--spacing-mm", options.spacing_mm,
                 "Particle spacing in millimetres, instead of the spec's")
      ->check(CLI::Range(0.2, 1000.0))
      ->type_name("X");
}

void add_mix_revisions(CLI::App& app, CommonOptions& options) {
  app.add_flag("--mix-revisions", options.mix_revisions,
               "Continue a study whose designs were simulated with other physics: their numbers do "
               "not compare");
}

void add_jobs(CLI::App& app, CommonOptions& options, const std::string& what) {
  app.add_option("-j,--jobs", options.jobs, what + " (default: the number of cores)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
}

std::filesystem::path output_folder(const CommonOptions& options, const std::string& name,
                                    const std::string& verb) {
  if (!options.out.empty()) return options.out;
  std::string ending = verb.empty() ? "" : "-" + verb;
  if (options.spacing_mm) ending += "-" + records::shortest_number(*options.spacing_mm) + "mm";
  const std::filesystem::path runs = "runs", early = records::file_name_of_0_1_0(name) + ending;
  // A study that an earlier version began is continued where it is.
  if (name_in(runs / early) == name) return runs / early;
  return runs / (records::file_name(name) + ending);
}

}  // namespace parapet::cli
