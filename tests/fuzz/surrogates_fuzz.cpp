// surrogates.json of a stranger: each stored process can be used or says why not.
#include <exception>

#include "fuzz_input.hpp"
#include "stored_surrogates.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parapet;
  const designs::Json json = designs::Json::parse(data, data + size, nullptr, false);
  if (!json.is_object() || !json.contains("metrics") || !json["metrics"].is_array()) return 0;
  for (const designs::Json& metric : json["metrics"]) {
    try {
      study::stored_process(json, metric);
    } catch (const std::exception& error) {
      fuzz::require(error.what()[0] != '\0', "a process that cannot be read says why");
    }
  }
  return 0;
}
