#include "companion_file.hpp"

#include "parapet/records/atomic_file.hpp"

namespace parapet::study {

using designs::Json;

Json read_quietly(const std::filesystem::path& file) {
  try {
    Json json = Json::parse(records::read_own_file(file), nullptr, false);
    return json.is_object() ? json : Json();
  } catch (const records::FileError&) {
    return nullptr;
  }
}

Json read_companion(const std::filesystem::path& file, const char* format,
                    const std::string& spec_hash) {
  Json json = read_quietly(file);
  const auto is = [&](const char* key, const std::string& wanted) {
    return json.value(key, Json()) == wanted;
  };
  const bool fits = !json.is_null() && is("format", format) && is("spec_hash", spec_hash);
  return fits ? json : Json();
}

std::optional<double> optional_number(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

}  // namespace parapet::study
