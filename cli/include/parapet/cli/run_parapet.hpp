/// The program `parapet` as a function: for `main`, and for other languages' ways to start it.
#pragma once

#include "parapet/records/program_info.hpp"
#include "parapet/study/local_service.hpp"

namespace parapet::cli {

/// Runs the verb that the arguments name, the program's name first, and gives the exit code: 0
/// done, 1 failed, 2 bad input, 130 interrupted. Messages go to standard error. Takes over SIGINT,
/// SIGTERM and SIGHUP. Never throws.
/// @param service who simulates the designs of studies, the rows of sweeps and what confirms a
///        design
int run_parapet(int argc, char** argv, study::ServiceFactory service = study::local_service());

/// Version and git revision that this program was built from; the revision is empty outside a
/// repository.
records::ProgramInfo program_info();

}  // namespace parapet::cli
