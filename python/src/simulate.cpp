#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interruptible.hpp"
#include "json_objects.hpp"
#include "parapet/cli/run_parapet.hpp"
#include "parapet/records/flow_recording.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/records/scene_json.hpp"
#include "parapet/solver/uncertainty.hpp"
#include "parapet/study/spec_files.hpp"
#include "parapet/study/thread_count.hpp"
#include "parts.hpp"

namespace parapet::python {
namespace {

namespace py = pybind11;
using designs::CaseSpec;
using designs::Json;

/// What a script says of its progress: seconds of flow done, and to come at most.
using ProgressCall = std::function<void(double, double)>;

/// A state of the flow that outlives the solver's callback. Single precision: for pictures.
struct KeptFrame {
  double time = 0.0;
  std::vector<float> x, z, u, w, pressure;
};

std::vector<float> single(std::span<const double> values) {
  std::vector<float> result(values.size());
  std::ranges::transform(values, result.begin(), [](double v) { return static_cast<float>(v); });
  return result;
}

/// Keeps frames of a run of unknown length, evenly spread: when there are too many, every second
/// one goes.
class FrameKeeper {
 public:
  explicit FrameKeeper(std::size_t most) : most_(most) {}

  void add(const solver::Frame& frame) {
    if (seen_++ % stride_ != 0 && !frame.last) return;
    frames_.push_back({frame.time, single(frame.x), single(frame.z), single(frame.u),
                       single(frame.w), single(frame.pressure)});
    if (frames_.size() <= most_) return;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < frames_.size(); k += 2) frames_[kept++] = std::move(frames_[k]);
    frames_.resize(kept);
    stride_ *= 2;
  }

  std::vector<KeptFrame> take() { return std::move(frames_); }

 private:
  std::size_t most_;
  std::size_t seen_ = 0, stride_ = 1;
  std::vector<KeptFrame> frames_;
};

struct Run {
  solver::Result result;
  std::vector<KeptFrame> frames;
};

/// What simulate() is asked for.
struct Wishes {
  int threads = 1;
  int jobs = 1;
  bool uncertainty = false;
  std::size_t frames = 0;
};

Run simulate_case(const CaseSpec& spec, const Wishes& wishes, const std::atomic<bool>& cancelled,
                  const std::function<void(const solver::Progress&)>& on_progress) {
  FrameKeeper keeper(std::max<std::size_t>(2, wishes.frames));
  solver::RunOptions run = spec.run;
  run.threads = wishes.threads;
  if (wishes.frames > 0) {
    run.frame_interval = records::recording_interval(spec.scene, run.stop_time);
  }
  std::function<void(const solver::Frame&)> on_frame;
  if (wishes.frames > 0) on_frame = [&](const solver::Frame& frame) { keeper.add(frame); };
  Run out;
  if (wishes.uncertainty) {
    solver::UncertaintyPlan plan;
    plan.jobs = wishes.jobs;
    out.result = solver::simulate_with_uncertainty(
        spec.scene, spec.numerics, run, plan,
        [&](double done) {
          on_progress({.time = done * run.stop_time, .stop_time = run.stop_time, .steps = 0});
          return !cancelled;
        },
        on_frame);
  } else {
    solver::Callbacks callbacks;
    callbacks.on_frame = on_frame;
    callbacks.on_progress = [&](const solver::Progress& progress) {
      on_progress(progress);
      return !cancelled;
    };
    out.result = solver::simulate(spec.scene, spec.numerics, run, callbacks);
  }
  out.frames = keeper.take();
  return out;
}

template <typename Number>
py::bytes raw(const std::vector<Number>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number)};
}

py::dict answer_of(const CaseSpec& spec, const Run& run, int threads) {
  const Json provenance =
      records::provenance_json(cli::program_info(), records::case_hash(spec), spec);
  std::vector<double> table;
  for (const auto& row : run.result.series.rows) table.insert(table.end(), row.begin(), row.end());
  py::list frames;
  for (const KeptFrame& frame : run.frames) {
    frames.append(py::make_tuple(frame.time, raw(frame.x), raw(frame.z), raw(frame.u), raw(frame.w),
                                 raw(frame.pressure)));
  }
  py::dict out;
  out["json"] =
      to_python(records::result_json(spec.name, run.result, spec.resolved, provenance, threads));
  out["columns"] = run.result.series.columns;
  out["series"] = raw(table);
  out["frames"] = frames;
  return out;
}

py::dict simulate(const std::string& text, const std::string& file,
                  std::optional<double> spacing_mm, std::optional<int> threads, int jobs,
                  bool uncertainty, int frames, const std::optional<ProgressCall>& progress) {
  const CaseSpec spec = study::case_of({designs::parse_json(text, file), file}, spacing_mm);
  const Wishes wishes{
      .threads = uncertainty ? 1 : threads.value_or(study::worthwhile_threads(spec, jobs)),
      .jobs = jobs,
      .uncertainty = uncertainty,
      .frames = static_cast<std::size_t>(std::max(0, frames))};
  std::mutex mutex;
  solver::Progress latest;
  const Run run = run_interruptibly(
      [&](const std::atomic<bool>& cancelled) {
        return simulate_case(spec, wishes, cancelled, [&](const solver::Progress& now) {
          const std::scoped_lock lock(mutex);
          latest = now;
        });
      },
      [&] {
        if (!progress) return;
        solver::Progress now;
        {
          const std::scoped_lock lock(mutex);
          now = latest;
        }
        (*progress)(now.time, now.stop_time);
      });
  return answer_of(spec, run, wishes.threads);
}

}  // namespace

void add_simulate(py::module_& module) {
  module.def("load_case", [](const std::string& argument) {
    const study::SpecDocument document = study::read_spec(argument);
    return py::make_tuple(to_python(study::case_of(document, {}).resolved), document.file);
  });
  module.def("resolve_case", [](const std::string& text, const std::string& file) {
    return to_python(study::case_of({designs::parse_json(text, file), file}, {}).resolved);
  });
  module.def("case_hash", [](const std::string& text, const std::string& file) {
    return records::case_hash(designs::parse_case(designs::parse_json(text, file), file));
  });
  module.def("scene", [](const std::string& text, const std::string& file) {
    return to_python(
        records::scene_json(designs::parse_case(designs::parse_json(text, file), file).scene));
  });
  module.def("simulate", &simulate);
  module.def("shipped_names", &designs::embedded_spec_names);
}

}  // namespace parapet::python
