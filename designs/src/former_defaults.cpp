// Names and defaults that earlier versions had. Whoever changes the default of a key that decides
// results adds the former one here, so that a study of the earlier version is recognised as the
// same study.
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {
namespace {

struct FormerDefault {
  const char* pointer;  // in a case; * stands for every barrier
  double value;
};

constexpr std::array former_defaults{
    // physics 1
    FormerDefault{"/numerics/cg_tolerance_m_s2", 0.05},
    FormerDefault{"/numerics/skin_ratio", 0.45},
    FormerDefault{"/numerics/sound_speed_m_s", 35.0},
    FormerDefault{"/run/settled/earliest_time_s", 1.5},
    // in events of every size
    FormerDefault{"/channel/length_m", 3.0},
    FormerDefault{"/channel/height_m", 1.5},
    FormerDefault{"/channel/monitor_x_m", 1.1},
    FormerDefault{"/barriers/*/foot_x_m", 1.1},
    FormerDefault{"/barriers/*/height_m", 0.1},
    FormerDefault{"/barriers/*/thickness_m", 0.015},
    FormerDefault{"/barriers/*/deflector/length_m", 0.065},
    FormerDefault{"/numerics/spacing_m", 0.005},
    FormerDefault{"/numerics/cg_tolerance_m_s2", 0.5},
    FormerDefault{"/run/stop_time_s", 6.0},
    FormerDefault{"/run/series_interval_s", 0.005},
    FormerDefault{"/run/settled/window_s", 0.25},
};

// Loads of version 0.1.0. What its windows of 5 ms measured in the flume is what the slam metrics
// measure there.
struct FormerName {
  std::string_view name, now;
};
constexpr std::array former_names{
    FormerName{"_peak_force_n_per_m", "_slam_force_n_per_m"},
    FormerName{"_peak_force_time_s", "_slam_force_time_s"},
    FormerName{"_peak_moment_nm_per_m", "_slam_moment_nm_per_m"},
};

/// The places that a pointer of the table stands for.
std::vector<std::string> places(const std::string& pointer, const Json& stored_case) {
  const std::size_t star = pointer.find('*');
  if (star == std::string::npos) return {pointer};
  std::vector<std::string> result;
  const Json::json_pointer list(pointer.substr(0, star - 1));
  const std::size_t n = stored_case.contains(list) ? stored_case[list].size() : 0;
  for (std::size_t k = 0; k < n; ++k) {
    result.push_back(std::string(pointer).replace(star, 1, std::to_string(k)));
  }
  return result;
}

}  // namespace

std::string with_present_names(std::string text) {
  for (const FormerName& former : former_names) {
    for (std::size_t at = text.find(former.name); at != std::string::npos;
         at = text.find(former.name, at)) {
      text.replace(at, former.name.size(), former.now);
    }
  }
  return text;
}

Json with_present_names(const Json& stored) {
  if (stored.is_string()) return with_present_names(stored.get<std::string>());
  if (stored.is_array()) {
    Json result = Json::array();
    for (const Json& item : stored) result.push_back(with_present_names(item));
    return result;
  }
  if (!stored.is_object()) return stored;
  Json result = Json::object();
  for (const auto& [key, item] : stored.items()) {
    result[with_present_names(key)] = with_present_names(item);
  }
  return result;
}

Json without_former_defaults(Json stored, const Json& now) {
  if (!stored.is_object() || !stored.contains("case")) return stored;
  for (const FormerDefault& former : former_defaults) {
    for (const std::string& pointer : places(former.pointer, stored.at("case"))) {
      const Json::json_pointer place("/case" + pointer);
      if (!stored.contains(place) || stored[place] != former.value) continue;
      if (now.contains(place) && now[place] == former.value) continue;
      stored[place.parent_pointer()].erase(place.back());
    }
  }
  return stored;
}

}  // namespace parapet::designs
