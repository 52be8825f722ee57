/// Which build of the program this is.
#pragma once

#include "parapet/records/program_info.hpp"

namespace parapet::cli {

/// Version and git revision that this program was built from; the revision is empty outside a
/// repository.
records::ProgramInfo program_info();

}  // namespace parapet::cli
