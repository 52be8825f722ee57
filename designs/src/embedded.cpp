#include "embedded.hpp"

#include <string>

#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {
namespace {

constexpr const char* schema_ending = ".schema.json";

const char* embedded_text(const std::string& file_name) {
  for (const EmbeddedFile& file : embedded_files()) {
    if (file_name == file.name) return file.text;
  }
  return nullptr;
}

}  // namespace

const char* embedded_spec(const std::string& name) {
  return name.ends_with(".schema") ? nullptr : embedded_text(name + ".json");
}

const char* embedded_schema(const std::string& kind) {
  return embedded_text(kind + schema_ending);
}

std::vector<std::string> embedded_spec_names() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embedded_files()) {
    const std::string name = file.name;
    if (!name.ends_with(schema_ending)) names.push_back(name.substr(0, name.size() - 5));
  }
  return names;
}

}  // namespace parapet::designs
