// Any text is a sweep or is refused; one that is taken resolves to itself.
#include "fuzz_input.hpp"
#include "parapet/designs/study_spec.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parapet;
  if (fuzz::quotes_the_library(data, size)) return 0;
  designs::SweepSpec sweep;
  if (!fuzz::taken([&] {
        sweep =
            designs::parse_sweep(designs::parse_json(fuzz::text_of(data, size), "fuzz"), "fuzz");
      })) {
    return 0;
  }
  const std::string resolved = sweep.resolved.dump();
  designs::SweepSpec again;
  fuzz::require(fuzz::taken([&] {
                  again = designs::parse_sweep(designs::parse_json(resolved, "again"), "again");
                }),
                "a resolved sweep is a sweep");
  fuzz::require(again.resolved.dump() == resolved, "a resolved sweep resolves to itself");
  return 0;
}
