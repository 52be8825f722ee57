/// Names of things as names of files.
#pragma once

#include <string>

namespace parapet::records {

/// A name of letters, digits, '-', '_' and '.' as it is; anything else becomes '_', and '-' and
/// eight hexadecimal digits of the name's hash then keep two names apart. Never hidden, never "..".
/// @param name not empty
std::string file_name(const std::string& name);

/// How versions up to 0.1.0 wrote it: without the hash.
std::string file_name_of_0_1_0(const std::string& name);

}  // namespace parapet::records
