#include "parapet/study/verify.hpp"

#include <bit>
#include <cstdint>
#include <map>
#include <utility>

#include "parapet/designs/error.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/study/simulator.hpp"
#include "simulate_in_order.hpp"

namespace parapet::study {
namespace {

std::string text_of(const std::optional<double>& value) {
  return value ? records::shortest_number(*value) : "absent";
}

bool same(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return std::bit_cast<std::uint64_t>(*a) == std::bit_cast<std::uint64_t>(*b);
}

}  // namespace

std::vector<std::size_t> spread_sample(std::size_t total, std::size_t count) {
  std::vector<std::size_t> chosen;
  if (count >= total) count = total;
  for (std::size_t k = 0; k < count; ++k) {
    chosen.push_back(count == 1 ? total - 1 : k * (total - 1) / (count - 1));
  }
  return chosen;
}

std::vector<Difference> compare(const StoredRun& stored, const records::Simulation& now) {
  std::vector<Difference> differences;
  if (stored.ok && *stored.ok != now.ok) {
    differences.push_back({"status", *stored.ok ? "ok" : "failed", now.ok ? "ok" : now.reason});
  } else if (stored.ok && !now.ok && stored.reason != now.reason) {
    differences.push_back({"reason", stored.reason, now.reason});
  }
  std::map<std::string, std::optional<double>> values;
  for (const solver::Metric& metric : now.metrics) values[metric.key] = metric.value;
  for (const solver::Metric& metric : stored.metrics) {
    const auto found = values.find(metric.key);
    if (found == values.end()) {
      differences.push_back({metric.key, text_of(metric.value), "not computed by this program"});
    } else if (!same(metric.value, found->second)) {
      differences.push_back({metric.key, text_of(metric.value), text_of(found->second)});
    }
  }
  return differences;
}

std::optional<std::vector<VerifiedRun>> verify_runs(
    const std::vector<StoredRun>& runs, const std::vector<std::size_t>& chosen,
    SimulationService& service, const std::function<void(const VerifiedRun&)>& on_verified) {
  std::vector<VerifiedRun> verified(chosen.size());
  bool cancelled = false;
  const auto end = [&](std::size_t k, const records::Simulation& simulation) {
    if (simulation.cancelled) {
      cancelled = true;
      return;
    }
    verified[k] = {chosen[k], compare(runs[chosen[k]], simulation)};
    if (on_verified) on_verified(verified[k]);
  };
  const auto begin = [&](std::size_t k) -> std::optional<SimulationTask> {
    try {
      return runs[chosen[k]].task();
    } catch (const designs::InputError& error) {
      end(k, impossible_scene(error.what()));
      return std::nullopt;
    }
  };
  simulate_in_order(service, chosen.size(), begin, end, [&] { return cancelled; });
  if (cancelled) return std::nullopt;
  return verified;
}

}  // namespace parapet::study
