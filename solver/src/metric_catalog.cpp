#include "parapet/solver/metric_catalog.hpp"

#include <charconv>

#include "gauges/metric_table.hpp"

namespace parapet::solver {
namespace {

MetricInfo info_of(std::string key, const MetricEntry& entry) {
  MetricInfo info;
  info.key = std::move(key);
  info.unit = entry.unit;
  info.least = entry.least;
  info.greatest = entry.greatest;
  for (const Absent* reason : absent_when(entry)) {
    info.absent_when.emplace_back(reason->text);
    info.may_not_exist = info.may_not_exist || reason->kind == Absence::does_not_exist;
  }
  info.definition = entry.definition;
  return info;
}

}  // namespace

std::vector<MetricInfo> metric_catalog(int n_barriers) {
  std::vector<MetricInfo> catalog;
  for_each_metric(static_cast<std::size_t>(n_barriers),
                  [&](std::string key, const MetricEntry& entry, std::size_t) {
                    catalog.push_back(info_of(std::move(key), entry));
                  });
  return catalog;
}

std::vector<MetricInfo> metric_definitions() {
  std::vector<MetricInfo> definitions;
  const MetricTable table = metric_table();
  for (const auto& part : {table.with_barrier, table.every_run, table.each_barrier}) {
    for (const MetricEntry& entry : part) {
      definitions.push_back(info_of(std::string(entry.key), entry));
    }
  }
  return definitions;
}

std::optional<MetricInfo> find_metric_info(std::string_view key) {
  const MetricTable table = metric_table();
  for (const auto& part : {table.with_barrier, table.every_run}) {
    for (const MetricEntry& entry : part) {
      if (entry.key == key) return info_of(std::string(key), entry);
    }
  }
  constexpr std::string_view barrier = "barrier_";
  if (!key.starts_with(barrier)) return std::nullopt;
  std::size_t number = 0;
  std::from_chars(key.data() + barrier.size(), key.data() + key.size(), number);
  if (number == 0) return std::nullopt;
  for (const MetricEntry& entry : table.each_barrier) {
    if (barrier_key(entry, number - 1) == key) return info_of(std::string(key), entry);
  }
  return std::nullopt;
}

}  // namespace parapet::solver
