// Any text is a case or is refused; a case that is taken reads the same from what it resolved to.
#include "fuzz_input.hpp"
#include "parapet/designs/case_spec.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parapet;
  if (fuzz::quotes_the_library(data, size)) return 0;
  designs::CaseSpec spec;
  if (!fuzz::taken([&] {
        spec = designs::parse_case(designs::parse_json(fuzz::text_of(data, size), "fuzz"), "fuzz");
      })) {
    return 0;
  }
  const std::string resolved = spec.resolved.dump();
  designs::CaseSpec again;
  fuzz::require(fuzz::taken([&] {
                  again = designs::parse_case(designs::parse_json(resolved, "again"), "again");
                }),
                "a resolved case is a case");
  fuzz::require(again.resolved.dump() == resolved, "a resolved case resolves to itself");
  return 0;
}
