// The runs of one method on one problem, as a file: what a method asked for, not yet scored.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "methods.hpp"

namespace parapet::bench::search {

struct MethodRuns {
  std::string method;  // for example "nsga2"
  std::string label;   // for people: "NSGA-II (pagmo2)"
  std::string family;  // methods of one family are variants: the best one stands for it
  std::vector<Run> runs;
};

nlohmann::ordered_json to_json(const MethodRuns& runs);
MethodRuns runs_from_json(const nlohmann::ordered_json& json);

// All *.json of a folder, by file name.
std::vector<MethodRuns> read_runs(const std::filesystem::path& folder);

}  // namespace parapet::bench::search
