#include "simulate_in_order.hpp"

#include <map>
#include <utility>

namespace parapet::study {

void simulate_in_order(
    SimulationService& service, std::size_t count,
    const std::function<std::optional<SimulationTask>(std::size_t index)>& begin,
    const std::function<void(std::size_t index, records::Simulation simulation)>& end,
    const std::function<bool()>& stop) {
  const auto places = static_cast<std::size_t>(service.places());
  std::map<std::size_t, std::size_t> under_way;  // index by ticket
  std::size_t next = 0;
  while (true) {
    if (next < count && under_way.size() < places && !stop()) {
      if (auto task = begin(next)) under_way.emplace(service.submit(*std::move(task)), next);
      ++next;
      continue;
    }
    if (under_way.empty()) return;
    EndedSimulation ended = service.wait();
    const auto found = under_way.find(ended.ticket);
    const std::size_t index = found->second;
    under_way.erase(found);
    if (ended.failure) std::rethrow_exception(ended.failure);
    end(index, std::move(ended.simulation));
  }
}

}  // namespace parapet::study
