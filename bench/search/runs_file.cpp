#include "runs_file.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace parapet::bench::search {

using Json = nlohmann::ordered_json;

Json to_json(const MethodRuns& runs) {
  Json json = {{"method", runs.method},
               {"label", runs.label},
               {"family", runs.family},
               {"runs", Json::array()}};
  for (const Run& run : runs.runs) {
    Json steps = Json::array();
    for (const Step& step : run.steps) {
      steps.push_back({{"x", step.x}, {"level", step.level}, {"seconds", step.seconds}});
    }
    json["runs"].push_back(
        {{"seed", run.seed}, {"own_seconds", run.own_seconds}, {"steps", std::move(steps)}});
  }
  return json;
}

MethodRuns runs_from_json(const Json& json) {
  MethodRuns runs{json.at("method"), json.at("label"), json.at("family"), {}};
  for (const Json& one : json.at("runs")) {
    Run run;
    run.seed = one.at("seed");
    run.own_seconds = one.at("own_seconds");
    for (const Json& step : one.at("steps")) {
      run.steps.push_back({step.at("x").get<Design>(), step.at("level"), step.at("seconds")});
    }
    runs.runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<MethodRuns> read_runs(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<MethodRuns> all;
  for (const std::filesystem::path& file : files) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    all.push_back(runs_from_json(Json::parse(in)));
  }
  return all;
}

}  // namespace parapet::bench::search
