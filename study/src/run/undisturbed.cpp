#include "parapet/study/undisturbed.hpp"

#include "companion_file.hpp"
#include "parapet/records/approach_json.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/study/thread_count.hpp"

namespace parapet::study {
namespace {

using designs::Json;

constexpr const char* file_name = "approach.json";

/// The base case at the finest spacing, gauged to the channel's end: a search may move barriers.
/// Nothing where its scenarios are other events, where it has no barrier, or where it is
/// impossible.
std::optional<designs::CaseSpec> base_event(designs::StudySpec study) {
  if (!study.scenarios.empty()) return std::nullopt;
  study.undisturbed = nullptr;
  try {
    designs::CaseSpec spec =
        designs::design_case(study, {}, nullptr, designs::finest_spacing(study));
    if (spec.scene.barriers.empty()) return std::nullopt;
    return spec;
  } catch (const designs::InputError&) {
    return std::nullopt;
  }
}

solver::Scene open_scene(const designs::CaseSpec& spec) {
  solver::Scene scene = solver::undisturbed(spec.scene);
  scene.monitor_x = scene.domain_length;
  return scene;
}

std::shared_ptr<const designs::UndisturbedFlow> flow_of(const designs::CaseSpec& spec,
                                                        solver::ApproachProfile profile) {
  return std::make_shared<const designs::UndisturbedFlow>(
      designs::UndisturbedFlow{open_scene(spec), spec.run.gauges, std::move(profile)});
}

std::shared_ptr<const designs::UndisturbedFlow> read(const std::filesystem::path& folder,
                                                     const designs::CaseSpec& spec) {
  const Json json = read_quietly(folder / file_name);
  if (json.is_null()) return nullptr;
  try {
    if (json.at("format") != "parapet-approach/1") return nullptr;
    if (json.at("provenance").at("spec_hash") != records::case_hash(spec)) return nullptr;
    return flow_of(spec, records::profile_from_json(json));
  } catch (const Json::exception&) {
    return nullptr;
  }
}

}  // namespace

std::shared_ptr<const designs::UndisturbedFlow> read_undisturbed(
    const std::filesystem::path& folder, const designs::StudySpec& study) {
  const auto spec = base_event(study);
  return spec ? read(folder, *spec) : nullptr;
}

std::shared_ptr<const designs::UndisturbedFlow> make_undisturbed(
    const std::filesystem::path& folder, const designs::StudySpec& study,
    const records::ProgramInfo& program, int threads, const Hooks& hooks) {
  const auto spec = base_event(study);
  if (!spec) return nullptr;
  if (auto known = read(folder, *spec)) return known;
  solver::RunOptions run = spec->run;
  run.threads = worthwhile_threads(*spec, threads);
  const solver::UndisturbedRun open = solver::simulate_undisturbed(
      open_scene(*spec), spec->numerics, run, [&](const solver::Progress& progress) {
        if (hooks.on_simulation) hooks.on_simulation("without barriers", progress);
        return !(hooks.cancelled && hooks.cancelled());
      });
  if (hooks.on_simulation_ended) hooks.on_simulation_ended("without barriers");
  if (open.result.status == solver::Status::failed && hooks.on_message) {
    hooks.on_message("the run without barriers failed (" + open.result.reason +
                     "): the coefficients of hand formulas stay unknown");
  }
  if (open.result.status != solver::Status::ok) return nullptr;
  const Json provenance = records::provenance_json(program, records::case_hash(*spec), *spec);
  records::write_file_atomically(folder / file_name, records::json_text(records::approach_file_json(
                                                         *spec, open, nullptr, provenance)));
  return flow_of(*spec, open.profile);
}

}  // namespace parapet::study
