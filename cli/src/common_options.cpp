#include "common_options.hpp"

#include <algorithm>
#include <thread>

#include "parapet/records/result_json.hpp"

namespace parapet::cli {
namespace {

/// Letters, digits, '-', '_' and '.'; anything else becomes '_'. Never hidden, never "..".
std::string file_name_of(const std::string& name) {
  std::string text = name;
  for (char& c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '_' || c == '.';
    if (!plain) c = '_';
  }
  if (text.starts_with('.')) text.insert(0, "_");
  return text;
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

void add_jobs(CLI::App& app, CommonOptions& options, const std::string& what) {
  app.add_option("-j,--jobs", options.jobs, what + " (default: the number of cores)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
}

std::filesystem::path output_folder(const CommonOptions& options, const std::string& name,
                                    const std::string& verb) {
  if (!options.out.empty()) return options.out;
  std::string folder = file_name_of(name);
  if (!verb.empty()) folder += "-" + verb;
  if (options.spacing_mm) folder += "-" + records::shortest_number(*options.spacing_mm) + "mm";
  return std::filesystem::path("runs") / folder;
}

}  // namespace parapet::cli
