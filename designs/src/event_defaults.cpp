// Defaults that belong to the size of the event. The schema states them for the flume of its other
// defaults and marks them with x-scales-with; in any other event they grow with its length H0, with
// sqrt(H0/g) or with gravity.
#include <algorithm>
#include <cmath>

#include "case_parts.hpp"

namespace parapet::designs {
namespace {

/// The flume in which the schema states them.
constexpr double flume_depth = 0.2, flume_block = 0.3, flume_gravity = 9.81;  // [m], [m], [m/s2]

struct Event {
  double length;   ///< H0 [m]
  double block;    ///< length of the released block [m]
  double gravity;  ///< [m/s2]

  double scaled(double value, const std::string& by) const {
    const double longer = length / flume_depth, heavier = gravity / flume_gravity;
    if (by == "event_length") return length;
    if (by == "length_beyond_block") return block + (value - flume_block) * longer;
    if (by == "time") return value * std::sqrt(longer / heavier);
    if (by == "acceleration") return value * heavier;
    return value * longer;
  }
};

double within_bounds(const Json& schema, double value) {
  if (schema.contains("minimum")) value = std::max(value, schema.at("minimum").get<double>());
  if (schema.contains("maximum")) value = std::min(value, schema.at("maximum").get<double>());
  return value;
}

/// @param given what was written there; null: nothing
void scale(SchemaNode schema, const Json* given, Json& resolved, const Event& event) {
  schema = follow_reference(schema);
  if (schema->contains("allOf")) {
    for (const Json& part : schema->at("allOf")) {
      scale({schema.document, &part}, given, resolved, event);
    }
  }
  if (resolved.is_array() && schema->contains("items")) {
    for (std::size_t k = 0; k < resolved.size(); ++k) {
      const Json* item = given != nullptr && k < given->size() ? &given->at(k) : nullptr;
      scale({schema.document, &schema->at("items")}, item, resolved[k], event);
    }
  }
  if (!resolved.is_object() || !schema->contains("properties")) return;
  for (const auto& [key, part] : schema->at("properties").items()) {
    if (!resolved.contains(key)) continue;
    const SchemaNode node = follow_reference({schema.document, &part});
    const bool is_given = given != nullptr && given->is_object() && given->contains(key);
    if (!is_given && node->contains("x-scales-with")) {
      const std::string by = node->at("x-scales-with").get<std::string>();
      const double value = resolved.at(key).get<double>();
      resolved[key] = within_bounds(*node, event.scaled(value, by));
    } else {
      scale(node, is_given ? &given->at(key) : nullptr, resolved[key], event);
    }
  }
}

}  // namespace

void scale_defaults(SchemaNode schema, const Json& given, Json& resolved) {
  const Json::json_pointer length("/gauges/event_length_m");
  const Json& reservoir = resolved.at("reservoir");
  const Event event{given.contains(length) ? given.at(length).get<double>()
                                           : reservoir.at("height_m").get<double>(),
                    reservoir.at("length_m").get<double>(),
                    resolved.at("channel").at("gravity_m_s2").get<double>()};
  scale(schema, &given, resolved, event);
  Json& channel = resolved["channel"];
  const bool placed = given.contains(Json::json_pointer("/channel/monitor_x_m"));
  if (!placed && channel.at("monitor_x_m") > channel.at("length_m")) {
    channel["monitor_x_m"] = channel.at("length_m").get<double>();  // a short channel's end
  }
}

}  // namespace parapet::designs
