/// Whether two machines compute the same bits: a short simulation as a number.
#pragma once

#include <string>

#include "parapet/records/program_info.hpp"

namespace parapet::study {

/// Hash of every metric and of the whole time series of a short simulation (about a second), to the
/// bit. Equal on machines whose results may stand in one log.
std::string probe_hash();

/// What a machine must have in common with the one that asks it to simulate.
struct Identity {
  std::string version, git_revision;  ///< of the program
  int physics = 0;
  std::string compiler;
  std::string probe;  ///< probe_hash()
};

/// Of this program on this machine. Simulates the probe.
Identity identity(const records::ProgramInfo& program);

}  // namespace parapet::study
