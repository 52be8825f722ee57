// A case of the suite and what it is given to work with.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parapet/flow/flow.hpp"
#include "parapet/validation/scorecard.hpp"

namespace parapet::validation {

// Thrown out of a case when the suite is cancelled.
struct Cancelled {};

// Gives each flow a core: all cases run at once, each in its own thread, and every flow waits for
// one of the slots.
class Slots;

class CaseRun {
 public:
  CaseRun(Scorecard& card, std::filesystem::path folder, Slots& slots);

  // The full suite, or the quick version of continuous integration (seconds, coarse spacings).
  bool full() const { return card_.full; }

  // Carries out task(0) ... task(count - 1) side by side, each in a slot of its own. A task may
  // write what belongs to its index only. The first exception is thrown again here.
  // cost_s: rough CPU seconds of each, for the progress; the dearest should come first.
  void side_by_side(std::size_t count, const std::function<void(std::size_t)>& task,
                    const std::vector<double>& cost_s = {});

  // One task in a slot.
  void alone(const std::function<void()>& task, double cost_s = 1.0);

  // For time loops: throws Cancelled once the suite is.
  void check_cancelled() const;

  // For time loops: the particles of all flows of a case are to keep masses alike. From any thread.
  void watch_masses(const solver::Flow& flow) const;

  // Rows for the masses seen, when there were any.
  void add_masses();

  // Adds a row to the scorecard. Not from within tasks: the order of rows is the report's.
  void add(Measure measure);

  // Path for a figure "CASE_NAME.ENDING"; the card lists it.
  std::filesystem::path figure(std::string_view file_name);

 private:
  Scorecard& card_;
  std::filesystem::path folder_;
  Slots& slots_;
  mutable std::mutex mutex_;
  // Of the masses of a flow's particles over their mean: the worst of any flow.
  mutable struct {
    double deviation = 0.0, least = 1.0, largest = 1.0;
    bool seen = false;
  } masses_;
};

struct Case {
  std::string_view name;
  std::string_view title;
  void (*run)(CaseRun& run);
};

// In the order of the report; the files of the cases are named after them.
std::span<const Case> all_cases();

}  // namespace parapet::validation
