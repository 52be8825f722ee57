/// A duration as a person reads it.
#pragma once

#include <string>

namespace parapet::cli {

/// "45 s", "3 min 20 s", "2 h 5 min"; "?" when it is not finite.
std::string duration_text(double seconds);

}  // namespace parapet::cli
