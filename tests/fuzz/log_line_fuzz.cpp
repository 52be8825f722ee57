// A line of a log is a record or says why not; a record survives the way through its line.
#include <exception>

#include "fuzz_input.hpp"
#include "parapet/records/evaluation_log.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parapet;
  records::EvaluationRecord record;
  try {
    record = records::record_from_json(designs::Json::parse(data, data + size));
  } catch (const std::exception& error) {
    fuzz::require(error.what()[0] != '\0', "a line that is no record says why");
    return 0;
  }
  std::string line;
  try {
    line = records::to_json(record).dump();
  } catch (const designs::Json::type_error&) {
    return 0;  // texts that are no UTF-8: they cannot have come from a log
  }
  const auto again = records::record_from_json(designs::Json::parse(line));
  fuzz::require(records::to_json(again).dump() == line, "a record survives its line");
  return 0;
}
