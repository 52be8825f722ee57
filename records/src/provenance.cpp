#include "parapet/records/provenance.hpp"

#include "parapet/records/hashes.hpp"
#include "parapet/solver/thin_fluid.hpp"

namespace parapet::records {

std::string compiler_name() {
#if defined(__clang__)
  return std::string("Clang ") + __clang_version__;
#elif defined(__GNUC__)
  return std::string("GCC ") + __VERSION__;
#else
  return "unknown";
#endif
}

designs::Json provenance_json(const ProgramInfo& program, const std::string& spec_hash) {
  designs::Json json;
  json["program_version"] = program.version;
  json["physics"] = program.physics;
  json["compiler"] = compiler_name();
  if (!program.git_revision.empty()) json["git_revision"] = program.git_revision;
  json["spec_hash"] = spec_hash;
  return json;
}

designs::Json provenance_json(const ProgramInfo& program, const std::string& spec_hash,
                              const designs::CaseSpec& spec) {
  designs::Json json = provenance_json(program, spec_hash);
  json["spacing_m"] = spec.numerics.spacing;
  json["integrator"] = integrator_name(spec.numerics.integrator);
  if (solver::is_thin(spec.numerics, spec.scene.material)) json["thin_fluid"] = true;
  return json;
}

designs::Json study_provenance(const designs::StudySpec& study, const ProgramInfo& program) {
  designs::Json json = provenance_json(program, study_hash(study));
  json["seed"] = study.method.seed;
  return json;
}

std::string integrator_name(solver::Integrator integrator) {
  switch (integrator) {
    case solver::Integrator::implicit_viscosity:
      return "implicit_viscosity";
    case solver::Integrator::rk4_explicit:
      return "rk4_explicit";
  }
  return "unknown";
}

}  // namespace parapet::records
