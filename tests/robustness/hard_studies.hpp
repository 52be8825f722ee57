/// The tiny studies that kills and faults are tried on, and how hard to try.
#pragma once

#include <string>
#include <vector>

#include "parapet/designs/case_spec.hpp"

namespace parapet::test {

/// A study whose log does not depend on timing, and the jobs it runs with.
struct HardStudy {
  std::string name;
  designs::Json spec;
  std::string jobs;

  std::vector<std::string> command(const std::string& out) const {
    return {"optimize", name + ".json", "--out", out, "--jobs", jobs};
  }
};

/// BAYESIAN with one and two jobs, NLopt, and scenarios.
std::vector<HardStudy> hard_studies();

/// An environment variable as a number, or `fallback`: .ci/nightly asks for more than .ci/run.
int trials(const char* variable, int fallback);

}  // namespace parapet::test
