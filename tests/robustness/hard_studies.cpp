#include "hard_studies.hpp"

#include <cstdlib>

#include "tiny_specs.hpp"

namespace parapet::test {

std::vector<HardStudy> hard_studies() {
  designs::Json plain = tiny_search();
  plain.erase("scenarios");
  plain["objectives"][0].erase("statistic");
  plain["method"]["repeatable"] = true;
  designs::Json scenarios = tiny_search();
  scenarios["method"]["repeatable"] = true;
  scenarios["method"]["max_evaluations"] = 7;
  return {{"bayesian-1", plain, "1"},
          {"bayesian-2", plain, "2"},
          {"nlopt", tiny_study(), "1"},
          {"scenarios", scenarios, "2"}};
}

int trials(const char* variable, int fallback) {
  const char* text = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): one thread
  return text == nullptr ? fallback : std::atoi(text);
}

}  // namespace parapet::test
