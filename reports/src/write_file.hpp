/// Complete or not there: how every picture and frame reaches the disk.
#pragma once

#include <filesystem>
#include <string_view>

namespace parapet::reports {

/// Writes beside the target, then renames over it.
/// @throws std::runtime_error naming the file that cannot be written.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace parapet::reports
