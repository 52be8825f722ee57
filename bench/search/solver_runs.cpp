#include "solver_runs.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

constexpr double lattice_jitter = 0.01;  // share of the spacing, as in bench/calibration

// Standard output of a command. Exit code 1 is a failed simulation, which has a result too.
std::string output_of(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  char buffer[4096];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) {
    text.append(buffer, n);
  }
  pclose(pipe);
  return text;
}

SolverRun to_run(const Json& json) {
  SolverRun run;
  run.ok = json.at("status") == "ok";
  run.particle_steps = json.at("particle_steps");
  for (const auto& [name, value] : json.at("metrics").items()) {
    if (value.is_number()) run.metrics[name] = value.get<double>();
  }
  run.unknown = json.at("unknown").get<std::vector<std::string>>();
  return run;
}

}  // namespace

SolverRuns::SolverRuns(std::string program, const std::filesystem::path& study,
                       const std::filesystem::path& store,
                       const std::vector<std::string>& variables)
    : program_(std::move(program)), study_(study), store_(store), variables_(variables) {
  version_ = output_of(fmt::format("'{}' --version", program_));
  while (!version_.empty() && version_.back() == '\n') version_.pop_back();
  if (!version_.starts_with("parapet ")) {
    throw std::invalid_argument(program_ + " is not the program parapet");
  }
  if (store_.has_parent_path()) std::filesystem::create_directories(store_.parent_path());
  std::ifstream in(store_);
  for (std::string line; std::getline(in, line);) {
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded() || json.at("program") != version_) continue;  // a line broken off
    Design x;
    for (const std::string& name : variables_) x.push_back(json.at("design").at(name));
    known_[key(x, json.at("spacing_m"), json.at("lattice"))] = to_run(json);
  }
}

std::string SolverRuns::key(const Design& x, double spacing_m, int lattice) const {
  return Json{x, spacing_m, lattice}.dump();
}

// The study with its lattice moved, beside the store.
std::filesystem::path SolverRuns::study_of(int lattice) const {
  if (lattice == 0) return study_;
  std::ifstream in(study_);
  if (!in) throw std::invalid_argument("cannot read " + study_.string());
  Json json = Json::parse(in);
  json["case"]["numerics"]["lattice_jitter"] = lattice_jitter;
  json["case"]["numerics"]["lattice_seed"] = 100 + lattice;
  const std::filesystem::path file = store_.string() + fmt::format(".lattice-{}.json", lattice);
  std::ofstream out(file);
  out << json.dump(1) << '\n';
  return file;
}

Json SolverRuns::simulate(const Design& x, double spacing_m, int lattice) const {
  Json design = Json::object();
  for (std::size_t j = 0; j < x.size(); ++j) design[variables_[j]] = x[j];
  const std::string text = output_of(
      fmt::format("'{}' evaluate '{}' --design '{}' --spacing-mm {} --jobs 1 --quiet", program_,
                  study_of(lattice).string(), design.dump(), 1000.0 * spacing_m));
  const Json found = Json::parse(text, nullptr, false);
  if (found.is_discarded() || !found.contains("particle_steps")) {
    throw std::runtime_error("no result of the design " + design.dump() + ": " + text);
  }
  Json unknown = Json::array();
  if (const auto given = found.find("metrics_unknown");
      given != found.end() && given->is_object()) {
    for (const auto& [name, reason] : given->items()) unknown.push_back(name);
  }
  Json metrics = Json::object();
  if (found.at("metrics").is_object()) metrics = found.at("metrics");
  return {{"program", version_},          {"design", design},
          {"spacing_m", spacing_m},       {"lattice", lattice},
          {"status", found.at("status")}, {"particle_steps", found.at("particle_steps")},
          {"metrics", metrics},           {"unknown", unknown}};
}

const SolverRun& SolverRuns::run(const Design& x, double spacing_m, int lattice) {
  const std::string name = key(x, spacing_m, lattice);
  if (const auto found = known_.find(name); found != known_.end()) return found->second;
  const Json json = simulate(x, spacing_m, lattice);
  // one write, so that several processes may share the store
  const std::string line = json.dump() + '\n';
  std::ofstream out(store_, std::ios::app);
  out.write(line.data(), static_cast<std::streamsize>(line.size()));
  if (!out.flush()) throw std::runtime_error("cannot write " + store_.string());
  ++simulated_;
  return known_[name] = to_run(json);
}

}  // namespace parapet::bench::search
