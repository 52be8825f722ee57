/// Files of a study folder that tell more of the study, and that nothing depends on.
#pragma once

#include <filesystem>
#include <string>

#include "parapet/designs/study_spec.hpp"

namespace parapet::study {

/// The JSON object in a file; null when the file is missing or not whole.
designs::Json read_quietly(const std::filesystem::path& file);

/// The same; null also when the format is another one or the study is.
designs::Json read_companion(const std::filesystem::path& file, const char* format,
                             const std::string& spec_hash);

/// A number; empty for null.
/// @throws nlohmann::json::exception for anything else
std::optional<double> optional_number(const designs::Json& json);

}  // namespace parapet::study
