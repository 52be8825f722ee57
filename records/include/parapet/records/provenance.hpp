/// Where a number comes from: program, input and numerics.
#pragma once

#include <string>

#include "parapet/designs/case_spec.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/records/program_info.hpp"

namespace parapet::records {

/// Says in a record or refused design which program made it.
template <typename Record>
void set_program(Record& record, const ProgramInfo& program) {
  record.program_version = program.version;
  record.git_revision = program.git_revision;
  if constexpr (requires { record.physics; }) record.physics = program.physics;
}

/// Name and version of the compiler this library was built with.
std::string compiler_name();

/// {program_version, physics, compiler, git_revision?, spec_hash}: what holds for a whole study or
/// sweep.
designs::Json provenance_json(const ProgramInfo& program, const std::string& spec_hash);

/// The same with spacing_m and integrator of one simulation, and thin_fluid where its settings
/// apply. The number of threads is left out on purpose: no result depends on it.
designs::Json provenance_json(const ProgramInfo& program, const std::string& spec_hash,
                              const designs::CaseSpec& spec);

/// Provenance of what a study writes: the first form with the study's hash, and its seed.
designs::Json study_provenance(const designs::StudySpec& study, const ProgramInfo& program);

/// Name of an integrator as it stands in a case file.
std::string integrator_name(solver::Integrator integrator);

}  // namespace parapet::records
