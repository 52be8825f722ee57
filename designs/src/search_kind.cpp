#include <algorithm>
#include <cctype>

#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {

std::string algorithm_name(const StudySpec& study) {
  std::string name = study.method.algorithm;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

SearchKind search_kind(const StudySpec& study) {
  const std::string name = algorithm_name(study);
  if (name == "BAYESIAN") return SearchKind::bayesian;
  for (const char* known : {"SOBOL", "LATIN_HYPERCUBE", "FULL_FACTORIAL", "LIST"}) {
    if (name == known) return SearchKind::experiments;
  }
  const bool several =
      study.objectives.size() > 1 && study.method.scalarization != Scalarization::weighted_sum;
  return several ? SearchKind::scalarized : SearchKind::weighted_sum;
}

bool is_laid_out_for_budget(const StudySpec& study) {
  return search_kind(study) == SearchKind::scalarized || algorithm_name(study) == "LATIN_HYPERCUBE";
}

double finest_spacing(const StudySpec& study) {
  if (!study.fidelity.empty()) return study.fidelity.front().spacing;
  return study.base_case.at("/numerics/spacing_m"_json_pointer).get<double>();
}

}  // namespace parapet::designs
