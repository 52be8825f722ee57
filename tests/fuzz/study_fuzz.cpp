// Any text is a study or is refused; one that is taken resolves to itself, and designs at the
// corners of its bounds are judged without anything else going wrong.
#include "fuzz_input.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/records/hashes.hpp"

namespace {

using namespace parapet;

designs::Design corner(const designs::StudySpec& study, bool upper) {
  designs::Design design;
  for (const designs::Variable& variable : study.variables) {
    design[variable.name] = upper ? variable.upper : variable.lower;
  }
  return design;
}

void try_corner(const designs::StudySpec& study, bool upper) {
  const designs::Design design = corner(study, upper);
  fuzz::taken([&] { designs::check_design(study, design, "fuzz"); });
  fuzz::taken([&] { designs::design_case(study, design); });
  for (const designs::Constraint& one : study.constraints) {
    if (one.expression.empty()) continue;
    fuzz::taken([&] { designs::evaluate_expression(study, one.expression, design); });
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (fuzz::quotes_the_library(data, size)) return 0;
  designs::StudySpec study;
  if (!fuzz::taken([&] {
        study =
            designs::parse_study(designs::parse_json(fuzz::text_of(data, size), "fuzz"), "fuzz");
      })) {
    return 0;
  }
  const std::string resolved = study.resolved.dump();
  designs::StudySpec again;
  fuzz::require(fuzz::taken([&] {
                  again = designs::parse_study(designs::parse_json(resolved, "again"), "again");
                }),
                "a resolved study is a study");
  fuzz::require(again.resolved.dump() == resolved, "a resolved study resolves to itself");
  fuzz::require(records::study_hash(again) == records::study_hash(study), "and keeps its hash");
  try_corner(study, false);
  try_corner(study, true);
  return 0;
}
