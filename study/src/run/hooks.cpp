#include "parapet/study/hooks.hpp"

namespace parapet::study {

ServiceHooks service_hooks(const Hooks& hooks) {
  ServiceHooks result;
  result.cancelled = hooks.cancelled;
  result.on_progress = [&hooks](const SimulationTask& task, const solver::Progress& progress) {
    if (hooks.on_simulation) hooks.on_simulation(task.label, progress);
  };
  return result;
}

}  // namespace parapet::study
