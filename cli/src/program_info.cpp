#include "program_info.hpp"

namespace parapet::cli {

records::ProgramInfo program_info() {
  return {.version = PARAPET_VERSION, .git_revision = PARAPET_GIT_REVISION};
}

}  // namespace parapet::cli
