// Any text is an expression over the variables or is refused.
#include "fuzz_input.hpp"
#include "parapet/designs/study_spec.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parapet;
  if (fuzz::quotes_the_library(data, size)) return 0;
  const designs::Design design{{"angle_deg", 30.0}, {"height_m", 0.1}, {"n", 2.0}};
  fuzz::taken([&] { designs::evaluate_expression(fuzz::text_of(data, size), design); });
  return 0;
}
