#include <algorithm>
#include <map>
#include <set>

#include "page_html.hpp"
#include "parapet/math/pareto.hpp"
#include "parapet/study/comparable.hpp"
#include "parapet/study/scoring.hpp"
#include "study_columns.hpp"

namespace parapet::reports {
namespace {

namespace fs = std::filesystem;
using designs::Json;
using designs::Objective;

/// One of the studies that are laid side by side.
struct Member {
  std::string label;  ///< its name; with its folder where two have one name
  study::LoadedStudy study;
  Recommendation advice;
  std::size_t first_row = 0;
};

std::vector<Member> members(const std::vector<fs::path>& folders, const PageOptions& options) {
  std::vector<Member> list;
  std::map<std::string, int> names;
  for (const fs::path& folder : folders) {
    study::LoadedStudy study = study::load_study_folder(folder);
    Recommendation advice = recommend(study, options.rule);
    ++names[study.spec.name];
    list.push_back({study.spec.name, std::move(study), std::move(advice)});
  }
  for (Member& one : list) {
    if (names[one.label] > 1) one.label += " (" + one.study.folder.string() + ")";
  }
  return list;
}

bool same(const Objective& a, const Objective& b) {
  return study::objective_name(a) == study::objective_name(b) && a.metric == b.metric &&
         a.expression == b.expression && a.goal == b.goal && a.statistic == b.statistic &&
         (a.statistic != designs::Statistic::quantile || a.quantile == b.quantile) &&
         a.lower == b.lower && a.upper == b.upper;
}

/// The objectives that all of them have, in the order of the first.
std::vector<Objective> shared_objectives(const std::vector<Member>& list) {
  std::vector<Objective> shared;
  for (const Objective& one : list.front().study.spec.objectives) {
    const bool everywhere = std::ranges::all_of(list, [&](const Member& other) {
      return std::ranges::any_of(other.study.spec.objectives,
                                 [&](const Objective& theirs) { return same(one, theirs); });
    });
    if (everywhere) shared.push_back(one);
  }
  if (!shared.empty()) return shared;
  std::string theirs;
  for (const Objective& one : list.back().study.spec.objectives) {
    if (!theirs.empty()) theirs += ", ";
    theirs += study::objective_name(one);
  }
  throw designs::InputError(
      {{.file = list.back().study.folder.string(),
        .pointer = "",
        .value = theirs,
        .problem = "shares no objective with " + list.front().study.folder.string(),
        .allowed = "studies with at least one objective in common: the same "
                   "metric or expression, goal and statistic"}});
}

/// What makes two events differ: a design that is best in one need not be so in the other.
Json event_of(const Member& one) {
  const Json& resolved = one.study.spec.resolved;
  Json event = Json::object();
  for (const char* key : {"channel", "reservoir", "material", "gauges"}) {
    event[key] = resolved.at("case").value(key, Json());
  }
  event["scenarios"] = resolved.value("scenarios", Json());
  return event;
}

/// Sentences about what makes the studies hard to compare.
std::vector<std::string> differences(const std::vector<Member>& list) {
  std::vector<std::string> sentences;
  const Member& first = list.front();
  for (std::size_t k = 1; k < list.size(); ++k) {
    const Member& other = list[k];
    const auto say = [&](const std::string& what) {
      sentences.push_back(other.label + " and " + first.label + " " + what);
    };
    if (event_of(other) != event_of(first)) {
      say("do not have the same event: channel, release, material, gauges or scenarios differ.");
    }
    if (other.advice.study.counted_spacing != first.advice.study.counted_spacing) {
      say("were simulated at different particle spacings: part of a difference may be that of the "
          "spacing.");
    }
    if (other.study.physics != first.study.physics) {
      say("were simulated by solvers of different physics numbers: their values do not compare.");
    }
  }
  return sentences;
}

/// Puts the rows of a study's column under those of the studies before it.
void append_column(Json& into, std::size_t first_row, std::size_t rows, const Json& values) {
  while (into.size() < first_row) into.push_back(nullptr);
  for (std::size_t row = 0; row < rows; ++row) into.push_back(values.at(row));
}

/// All designs in one table. `counts` says of each whether it was simulated at the spacing that
/// counts in its study.
Json joint_table(std::vector<Member>& list, const std::vector<Objective>& shared) {
  std::set<std::string> names;
  for (const Objective& one : shared) names.insert(study::objective_name(one));
  Json all = Json::object();
  std::size_t rows = 0;
  for (Member& member : list) {
    member.first_row = rows;
    Json own = designs_json(member.study, member.advice);
    const std::size_t n = own.at("id").size();
    for (Json& id : own["id"]) id = member.label + "/" + id.get<std::string>();
    for (const records::EvaluationRecord& one : member.study.designs) {
      own["counts"].push_back(one.spacing <= member.advice.study.counted_spacing * (1.0 + 1e-9));
    }
    own["variables"]["study"] = std::vector<std::string>(n, member.label);
    for (const auto& [key, value] : own.items()) {
      if (value.is_array()) {
        append_column(all[key], rows, n, value);
        continue;
      }
      for (const auto& [name, column] : value.items()) {
        if (key == "objectives" && !names.contains(name)) continue;
        append_column(all[key][name], rows, n, column);
      }
    }
    rows += n;
    for (auto& [key, value] : all.items()) {  // columns that this study does not have
      if (value.is_array()) continue;
      for (auto& [name, column] : value.items()) {
        while (column.size() < rows) column.push_back(nullptr);
      }
    }
  }
  return all;
}

/// Marks the front of all studies together, by the objectives that they share.
std::vector<int> mark_front(Json& table, const std::vector<Member>& list,
                            const std::vector<Objective>& shared) {
  std::vector<math::Objectives> points;
  std::vector<std::pair<std::size_t, std::size_t>> places;  // row, member
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto& designs = list[k].study.designs;
    for (const records::EvaluationRecord* one : study::ranked_designs(list[k].study, true)) {
      math::Objectives point(static_cast<Eigen::Index>(shared.size()));
      const auto row = list[k].first_row + static_cast<std::size_t>(one - designs.data());
      for (std::size_t j = 0; j < shared.size(); ++j) {
        const Json& value = table["objectives"][study::objective_name(shared[j])][row];
        const double sign = shared[j].goal == designs::Goal::maximize ? -1.0 : 1.0;
        point[static_cast<Eigen::Index>(j)] = sign * value.get<double>();
      }
      points.push_back(std::move(point));
      places.emplace_back(row, k);
    }
  }
  for (Json& mark : table["front"]) mark = false;
  std::vector<int> share(list.size(), 0);
  const std::vector<std::size_t> front = math::non_dominated(points);
  for (std::size_t k = 0; k < points.size(); ++k) {
    // Equal points are on it together: none of the studies found the others' design for them.
    const bool on_it =
        std::ranges::any_of(front, [&](std::size_t j) { return points[j] == points[k]; });
    if (!on_it) continue;
    table["front"][places[k].first] = true;
    ++share[places[k].second];
  }
  return share;
}

Json variables_json(const std::vector<Member>& list) {
  Json variables = Json::array(), labels = Json::array();
  for (const Member& one : list) labels.push_back(one.label);
  variables.push_back({{"name", "study"}, {"options", std::move(labels)}});
  std::set<std::string> known;
  for (const Member& one : list) {
    for (const designs::Variable& variable : one.study.spec.variables) {
      if (!known.insert(variable.name).second) continue;
      Json json{{"name", variable.name}};
      if (variable.kind == designs::VariableKind::choice) {
        Json options = Json::array();
        for (const designs::Option& option : variable.options) options.push_back(option.name);
        json["options"] = std::move(options);
      }
      variables.push_back(std::move(json));
    }
  }
  return variables;
}

}  // namespace

std::string studies_page(const std::vector<fs::path>& folders, const PageOptions& options) {
  std::vector<Member> list = members(folders, options);
  const std::vector<Objective> shared = shared_objectives(list);
  std::string name;
  for (const Member& one : list) {
    if (!name.empty()) name += ", ";
    name += one.label;
  }
  Json page = common_json("studies", name, "", options);
  page["variables"] = variables_json(list);
  page["objectives"] = Json::array();
  for (const Objective& one : shared) {
    page["objectives"].push_back(
        {{"name", study::objective_name(one)},
         {"metric", one.metric},
         {"goal", one.goal == designs::Goal::maximize ? "maximize" : "minimize"}});
  }
  page["designs"] = joint_table(list, shared);
  const std::vector<int> share = mark_front(page["designs"], list, shared);
  page["notes"] = differences(list);
  page["studies"] = Json::array();
  RunBlocks runs(page);
  std::string all;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Member& one = list[k];
    const DesignReport* shown = one.advice.shown();
    add_study_keys(page, one.study);
    page["studies"].push_back({{"label", one.label},
                               {"folder", one.study.folder.string()},
                               {"hash", one.study.spec_hash},
                               {"simulated_by", simulated_by(one.study.provenance)},
                               {"state", one.study.state},
                               {"spacing_m", one.advice.study.counted_spacing},
                               {"designs", one.study.designs.size()},
                               {"feasible", one.advice.study.feasible},
                               {"on_joint_front", share[k]},
                               {"recommended", one.advice.recommended && shown != nullptr
                                                   ? Json(one.label + "/" + shown->id)
                                                   : Json(nullptr)}});
    add_study_runs(runs, one.study, one.advice, options, {.drawn = 60, .with_series = 24},
                   one.label + "/");
    const std::string folder = shell_word(one.study.folder.string());
    add_command(page, "the page of " + one.label, "parapet report " + folder);
    all += " " + folder;
  }
  add_key(page, "study");
  add_command(page, "this page again", "parapet report" + all);
  return page_html(page, runs.blocks());
}

}  // namespace parapet::reports
