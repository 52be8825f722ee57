// Defaults that earlier versions had. Whoever changes the default of a key that decides results
// adds the former one here, so that a study of the earlier version is recognised as the same study.
#include <array>

#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {
namespace {

struct FormerDefault {
  const char* pointer;  // in a case
  double value;
};

constexpr std::array former_defaults{
    // physics 1
    FormerDefault{"/numerics/cg_tolerance_m_s2", 0.05},
    FormerDefault{"/numerics/skin_ratio", 0.45},
    FormerDefault{"/numerics/sound_speed_m_s", 35.0},
    FormerDefault{"/run/settled/earliest_time_s", 1.5},
};

}  // namespace

Json without_former_defaults(Json stored, const Json& now) {
  if (!stored.is_object() || !stored.contains("case")) return stored;
  for (const FormerDefault& former : former_defaults) {
    const Json::json_pointer place("/case" + std::string(former.pointer));
    if (!stored.contains(place) || stored[place] != former.value) continue;
    if (now.contains(place) && now[place] == former.value) continue;
    stored[place.parent_pointer()].erase(place.back());
  }
  return stored;
}

}  // namespace parapet::designs
