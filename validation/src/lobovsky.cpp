#include "lobovsky.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "embedded.hpp"

namespace parapet::validation {

double Lobovsky::clock_difference(double depth) const {
  const std::size_t n = front_t.size();
  const double slope = (front_x[n - 1] - front_x[n - 2]) / (front_t[n - 1] - front_t[n - 2]);
  const double wall = (tank_length - reservoir_length) / depth;
  return front_t[n - 1] + (wall - front_x[n - 1]) / slope - arrival_at_wall;
}

Lobovsky read_lobovsky() {
  const auto json = nlohmann::json::parse(embedded_text("lobovsky_2014.json"));
  const auto list = [](const nlohmann::json& j) { return j.get<std::vector<double>>(); };
  Lobovsky m;
  const auto& tank = json.at("tank");
  m.tank_length = tank.at("length_m");
  m.reservoir_length = tank.at("reservoir_length_m");
  const auto& levels = json.at("levels_H_0_3");
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string number = std::to_string(k + 1), gauge = fmt::format("H{}", number);
    m.sensor_z[k] = tank.at("sensor_z_m").at(number);
    const auto& peak = json.at("peak_pressure_H_0_3").at(number);
    m.peaks[k] = {peak.at("median"), peak.at("p2_5"), peak.at("p97_5")};
    MeasuredLevel& level = m.levels[k];
    level.x = tank.at("gauge_x_m").at(gauge);
    level.depth = {list(levels.at("t_star")),
                   list(levels.at(gauge).at("low")),
                   {},
                   list(levels.at(gauge).at("high"))};
    for (std::size_t i = 0; i < level.depth.t.size(); ++i) {
      level.depth.middle.push_back(0.5 * (level.depth.low[i] + level.depth.high[i]));
    }
    const auto& arrival = levels.at(gauge).at("arrival_t_star");
    if (arrival.is_null()) continue;
    level.arrival_low = std::min(arrival.at(0), arrival.at(1)).get<double>();
    level.arrival_high = std::max(arrival.at(0), arrival.at(1)).get<double>();
  }
  m.front_t = list(json.at("front_H_0_3").at("t_star"));
  m.front_x = list(json.at("front_H_0_3").at("x_over_H_from_gate"));
  const auto& sensor_2 = json.at("sensor_2_H_0_3");
  m.sensor_2 = {list(sensor_2.at("t_star")), list(sensor_2.at("p2_5")), list(sensor_2.at("median")),
                list(sensor_2.at("p97_5"))};
  m.sensor_1_t = list(json.at("sensor_1_one_run_H_0_3").at("t_star"));
  m.sensor_1_p = list(json.at("sensor_1_one_run_H_0_3").at("p"));
  const auto arrival = list(json.at("arrival_at_wall_t_star_H_0_3"));
  m.arrival_at_wall = 0.5 * (arrival.at(0) + arrival.at(1));
  const auto& high = json.at("peak_pressure_sensor_1_H_0_6");
  m.peak_1_high_dam = high.at("median");
  m.rise_time = 1e-3 * high.at("rise_time_ms_median").get<double>();
  m.decay_time = 1e-3 * high.at("decay_time_ms_median").get<double>();
  m.impulse = 100.0 * high.at("impulse_mbar_s_median").get<double>();
  return m;
}

}  // namespace parapet::validation
