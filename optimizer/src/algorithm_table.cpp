#include "algorithm_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <string_view>
#include <utility>

namespace parapet::optimizer {
namespace {

AlgorithmEntry local(const std::string& name, int per_variable, int points, int min_variables,
                     std::string note) {
  return {.info = {.name = name, .note = std::move(note)},
          .nlopt_name = "LN_" + name,
          .usable_as_local = true,
          .min_variables = min_variables,
          .points_per_variable = per_variable,
          .points = points};
}

AlgorithmEntry global(const std::string& name, bool randomized, int per_variable, int points,
                      std::string note) {
  return {.info = {.name = name, .global = true, .randomized = randomized, .note = std::move(note)},
          .nlopt_name = "GN_" + name,
          .points_per_variable = per_variable,
          .points = points};
}

AlgorithmEntry constrained(AlgorithmEntry entry) {
  entry.info.inequality_constraints = true;
  return entry;
}

AlgorithmEntry with_local(AlgorithmEntry entry) {
  entry.needs_local = true;
  return entry;
}

std::vector<AlgorithmEntry> make_table() {
  std::vector<AlgorithmEntry> table{
      constrained(local("COBYLA", 1, 2, 1,
                        "linear models in a trust region; the first choice for few evaluations "
                        "under constraints")),
      local("BOBYQA", 2, 2, 2, "quadratic model in a trust region; best on smooth objectives"),
      local("NEWUOA_BOUND", 2, 2, 2, "quadratic model; BOBYQA is usually better within bounds"),
      local("NELDERMEAD", 1, 2, 1, "simplex; tolerates some noise"),
      local("SBPLX", 1, 2, 1, "simplex in subspaces; tolerates noise, slow but robust"),
      local("PRAXIS", 1, 2, 2, "principal axes; has no bounds of its own, prefer BOBYQA"),
      global("DIRECT", false, 2, 1, "divides the box; ignores the starting points"),
      global("DIRECT_L", false, 2, 1, "divides the box, biased to local refinement"),
      global("DIRECT_L_RAND", true, 2, 1, "DIRECT_L that breaks ties at random"),
      constrained(global("ORIG_DIRECT", false, 2, 1,
                         "Gablonsky's DIRECT; constraints only as allowed or not")),
      constrained(global("ORIG_DIRECT_L", false, 2, 1,
                         "Gablonsky's DIRECT_L; constraints only as allowed or not")),
      global("CRS2_LM", true, 5, 6, "controlled random search; needs hundreds of evaluations"),
      constrained(global("ISRES", true, 0, 20,
                         "evolution strategy with constraint ranking; needs many evaluations")),
      global("ESCH", true, 0, 20, "evolutionary; needs many evaluations"),
      constrained(global("AGS", false, 0, 10,
                         "Lipschitz search along a space-filling curve; up to 5 variables and 10 "
                         "constraints; ignores the starting points")),
      with_local(global("MLSL", true, 0, 4, "local searches from random points")),
      with_local(global("MLSL_LDS", false, 0, 4, "local searches from low-discrepancy points")),
  };
  for (AlgorithmEntry& entry : table) {
    if (entry.info.name == "AGS") entry.max_variables = 5;
    if (entry.info.name == "PRAXIS") entry.info.randomized = true;  // its random steps
  }
  AlgorithmEntry auglag{.info = {.name = "AUGLAG",
                                 .inequality_constraints = true,
                                 .note = "augmented Lagrangian around local_algorithm (Parapet's "
                                         "own loop: NLopt's solves every subproblem from the full "
                                         "initial step)"},
                        .points = 0};
  table.push_back(with_local(auglag));
  return table;
}

std::string normalized(const std::string& name) {
  std::string text;
  for (const char c : name) {
    text +=
        c == '-' || c == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  for (const std::string_view prefix : {"NLOPT_", "LN_", "GN_", "G_"}) {
    if (text.starts_with(prefix)) text.erase(0, prefix.size());
  }
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> aliases = {{
      {"CRS2", "CRS2_LM"},
      {"CRS", "CRS2_LM"},
      {"NELDER_MEAD", "NELDERMEAD"},
      {"SUBPLEX", "SBPLX"},
      // In the unit box the variants without scaling are the same algorithms.
      {"DIRECT_NOSCAL", "DIRECT"},
      {"DIRECT_L_NOSCAL", "DIRECT_L"},
      {"DIRECT_L_RAND_NOSCAL", "DIRECT_L_RAND"},
      {"DIRECTL", "DIRECT_L"},
      {"MLSLLDS", "MLSL_LDS"},
  }};
  for (const auto& [alias, target] : aliases) {
    if (text == alias) return std::string(target);
  }
  return text;
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0U);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0U : 1U);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

/// A sentence for the gradient-based algorithms, and for those useless here; else empty.
std::string known_but_unusable(const std::string& text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 13> gradient = {{
      {"MMA", "COBYLA"},
      {"CCSAQ", "COBYLA"},
      {"SLSQP", "COBYLA"},
      {"LD_AUGLAG", "AUGLAG with the local_algorithm BOBYQA"},
      {"LBFGS", "BOBYQA"},
      {"TNEWTON", "BOBYQA"},
      {"VAR1", "BOBYQA"},
      {"VAR2", "BOBYQA"},
      {"LD_", "BOBYQA or COBYLA"},
      {"STOGO", "DIRECT_L"},
      {"GD_STOGO", "DIRECT_L"},
      {"GD_MLSL", "MLSL_LDS with the local_algorithm BOBYQA"},
      {"GD_", "DIRECT_L"},
  }};
  for (const auto& [start, instead] : gradient) {
    if (text.starts_with(start) || text.starts_with("LD_" + std::string(start))) {
      return text + " needs gradients and the simulation has none; use " + std::string(instead);
    }
  }
  if (text == "NEWUOA") return "NEWUOA ignores the bounds; use NEWUOA_BOUND or BOBYQA";
  if (text == "AUGLAG_EQ") return "AUGLAG_EQ is for equality constraints; use AUGLAG";
  return {};
}

}  // namespace

const std::vector<AlgorithmEntry>& algorithm_table() {
  static const std::vector<AlgorithmEntry> table = make_table();
  return table;
}

const AlgorithmEntry* find_algorithm(const std::string& name, std::string& why_not) {
  const std::string text = normalized(name);
  const AlgorithmEntry* nearest = nullptr;
  std::size_t least = 3;  // beyond two typing errors a suggestion is a guess
  std::string all;
  for (const AlgorithmEntry& entry : algorithm_table()) {
    if (entry.info.name == text) return &entry;
    const std::size_t distance = edit_distance(text, entry.info.name);
    if (distance < least) {
      least = distance;
      nearest = &entry;
    }
    all += (all.empty() ? "" : ", ") + entry.info.name;
  }
  why_not = known_but_unusable(text);
  if (why_not.empty()) {
    why_not = "unknown algorithm \"" + name + "\"" +
              (nearest ? " (did you mean " + nearest->info.name + "?)" : "") + "; known are " + all;
  }
  return nullptr;
}

int population_for(const AlgorithmEntry& entry, int n_variables, int max_evaluations) {
  const std::string& name = entry.info.name;
  const int affordable = max_evaluations / 4;
  if (name == "CRS2_LM") {
    return std::clamp(affordable, 5 * (n_variables + 1), 10 * (n_variables + 1));
  }
  if (name == "ISRES") return std::clamp(affordable, 10, 20 * (n_variables + 1));
  if (name == "ESCH") return std::clamp(affordable, 8, 40);
  return 0;
}

const std::vector<AlgorithmInfo>& algorithms() {
  static const std::vector<AlgorithmInfo> infos = [] {
    std::vector<AlgorithmInfo> list;
    for (const AlgorithmEntry& entry : algorithm_table()) list.push_back(entry.info);
    return list;
  }();
  return infos;
}

}  // namespace parapet::optimizer
