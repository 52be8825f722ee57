#include "parapet/study/probe.hpp"

#include <stdexcept>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::study {
namespace {

using designs::Json;

/// Coarse, and long enough that the flow has met the barrier and been launched.
designs::CaseSpec probe_case() {
  Json json = designs::parse_json(designs::embedded_spec("single_barrier"), "the probe");
  constexpr double spacing = 0.01, stop_time = 1.2;
  json["numerics"]["spacing_m"] = spacing;
  json["run"]["stop_time_s"] = stop_time;
  return designs::parse_case(json, "the probe");
}

}  // namespace

std::string probe_hash() {
  const designs::CaseSpec probe = probe_case();
  const solver::Result result = solver::simulate(probe.scene, probe.numerics, probe.run);
  if (result.status != solver::Status::ok) {
    throw std::runtime_error("the probe failed: " + result.reason);
  }
  Json bits;
  bits["metrics"] = records::metrics_json(result);
  bits["series"] = records::series_csv(result.series);
  return designs::spec_hash(bits);
}

Identity identity(const records::ProgramInfo& program) {
  return {.version = program.version,
          .git_revision = program.git_revision,
          .physics = program.physics,
          .compiler = records::compiler_name(),
          .probe = probe_hash()};
}

}  // namespace parapet::study
