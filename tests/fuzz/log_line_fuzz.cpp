// A line of a log is a record, a refused design, or says why not; each survives the way through its
// line, and the checksum of a line that we wrote is right.
#include <exception>
#include <optional>

#include "fuzz_input.hpp"
#include "parapet/records/checksum.hpp"
#include "parapet/records/evaluation_log.hpp"

namespace {

using namespace parapet;

/// The JSON of what a line holds, or nothing.
template <typename Read>
std::optional<designs::Json> read_line(const std::string& line, Read read) {
  try {
    return records::to_json(read(designs::Json::parse(line)));
  } catch (const std::exception& error) {
    fuzz::require(error.what()[0] != '\0', "a line that is no record says why");
    return std::nullopt;
  }
}

template <typename Read>
void try_line(const std::string& text, Read read) {
  const auto held = read_line(text, read);
  if (!held) return;
  std::string line;
  try {
    line = records::line_with_checksum(*held);
  } catch (const designs::Json::type_error&) {
    return;  // texts that are no UTF-8: they cannot have come from a log
  }
  fuzz::require(records::check_line(line) == records::LineChecksum::right, "the checksum is right");
  const auto again = read_line(line, read);
  fuzz::require(again && again->dump() == held->dump(), "a record survives its line");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::text_of(data, size);
  records::check_line(text);
  try_line(text, records::record_from_json);
  try_line(text, records::refused_from_json);
  return 0;
}
