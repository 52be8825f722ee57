/// Which program computed a result.
#pragma once

#include <string>

#include "parapet/solver/physics.hpp"

namespace parapet::records {

/// The program that computes; known when it was configured.
struct ProgramInfo {
  std::string version;
  std::string git_revision;  ///< empty when not built from a git checkout
  int physics = solver::physics_number;
};

}  // namespace parapet::records
