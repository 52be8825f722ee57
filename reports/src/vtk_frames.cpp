#include "parapet/reports/vtk_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/file_name.hpp"
#include "vtk_xml.hpp"

namespace parapet::reports {
namespace {

std::vector<float> scalars(std::span<const double> values) {
  std::vector<float> copy(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) copy[k] = static_cast<float>(values[k]);
  return copy;
}

bool convex(const std::vector<solver::Vec2>& corners) {
  bool left = false, right = false;
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const solver::Vec2 a = corners[k], b = corners[(k + 1) % n], c = corners[(k + 2) % n];
    const double turn = (b.x - a.x) * (c.z - b.z) - (b.z - a.z) * (c.x - b.x);
    (turn > 0.0 ? left : right) = true;
  }
  return !(left && right);
}

/// The bed with the wall behind the release, and every body as a closed line; numbered by barrier
/// from 1, upstream first, else 0. VTK fills convex polygons alone: stem and deflector come apart,
/// and another solid is filled when it is convex.
VtkShapes outlines(const solver::Scene& scene) {
  VtkShapes shapes{.lines = {{{0.0, scene.domain_height}, {0.0, 0.0}, {scene.domain_length, 0.0}}},
                   .polygons = {},
                   .name = "barrier",
                   .numbers = {0}};
  std::vector<std::int32_t> filled;
  const auto fill = [&](std::vector<solver::Vec2> corners, std::int32_t number) {
    shapes.polygons.push_back(std::move(corners));
    filled.push_back(number);
  };
  const auto close = [&](std::vector<solver::Vec2> corners, std::int32_t number) {
    corners.push_back(corners.front());
    shapes.lines.push_back(std::move(corners));
    shapes.numbers.push_back(number);
  };
  std::int32_t number = 0;
  for (const solver::Barrier& barrier : scene.barriers) {
    const auto corners = barrier_outline(scene, barrier);
    close(corners, ++number);
    if (corners.size() == 6) {  // foot, crest, tip, upper tip, joint, downstream foot
      fill({corners[0], corners[1], corners[4], corners[5]}, number);
      fill({corners[1], corners[2], corners[3], corners[4]}, number);
    } else {
      fill(corners, number);
    }
  }
  for (const solver::SolidPolygon& solid : scene.solids) {
    close(solid.vertices, 0);
    if (convex(solid.vertices)) fill(solid.vertices, 0);
  }
  shapes.numbers.insert(shapes.numbers.end(), filled.begin(), filled.end());
  return shapes;
}

/// Where the metrics look (docs/metrics.md), as lines as tall as the event (H0): what each is
/// stands in the header.
VtkShapes gauges(const solver::Scene& scene, const solver::GaugeSettings& settings) {
  const double tall = event_units(scene, settings).length;
  VtkShapes shapes{.lines = {}, .polygons = {}, .name = "gauge", .numbers = {}};
  const auto normal = [&](double x, std::int32_t number) {
    shapes.lines.push_back({{x, 0.0}, {x, tall}});
    shapes.numbers.push_back(number);
  };
  for (const solver::Barrier& barrier : scene.barriers) {
    const solver::Vec2 up = stem_direction(scene, barrier);
    const double reach = std::max(2.0 * barrier.height, tall);
    shapes.lines.push_back({{barrier.foot_x, 0.0}, {barrier.foot_x + reach * up.x, reach * up.z}});
    shapes.numbers.push_back(0);
  }
  const bool open = scene.barriers.empty();
  const double base = settings.front_base_ratio * tall;
  const double at = open ? scene.monitor_x : scene.barriers.front().foot_x;
  const double end = open ? at + 0.5 * base : at - settings.front_clearance_ratio * tall;
  normal(end - base, 1);
  normal(end, 1);
  normal(at - settings.energy_window_ratio * tall, 2);
  normal(at + settings.energy_window_ratio * tall, 2);
  if (open) {
    normal(at - settings.depth_window_ratio * tall, 3);
    normal(at, 3);
  }
  return shapes;
}

std::string frame_file(const solver::Frame& frame) {
  const std::string time = fmt::format(
      "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n</FieldData>\n",
      frame.time);
  const std::vector<std::int32_t> ids(frame.id.begin(), frame.id.end());
  const std::string fields = vtk_array("velocity_m_s", 3, vtk_vectors(frame.u, frame.w)) +
                             vtk_array("pressure_pa", 1, scalars(frame.pressure)) +
                             vtk_array("density_kg_m3", 1, scalars(frame.density)) +
                             vtk_array("viscosity_pa_s", 1, scalars(frame.viscosity)) +
                             vtk_array("id", 1, ids);
  return vtk_points(frame.x, frame.z, time, fields);
}

void check(const solver::Frame& frame) {
  const std::size_t n = frame.x.size();
  const std::array<std::size_t, 7> sizes{
      frame.z.size(),        frame.u.size(),         frame.w.size(), frame.density.size(),
      frame.pressure.size(), frame.viscosity.size(), frame.id.size()};
  for (const std::size_t size : sizes) {
    if (size != n) {
      throw std::invalid_argument(
          fmt::format("a frame's arrays must have one length; found {} beside {}", size, n));
    }
  }
  if (frame.wall_x.size() != frame.wall_z.size()) {
    throw std::invalid_argument("a frame's wall arrays must have one length");
  }
}

}  // namespace

FrameWriter::FrameWriter(std::filesystem::path directory, const std::string& case_name,
                         solver::Scene scene, const solver::GaugeSettings& settings)
    : directory_(std::move(directory)),
      stem_(records::file_name(case_name)),
      scene_(std::move(scene)),
      gauges_(settings) {
  if (case_name.empty()) throw std::invalid_argument("frames need a case name");
  records::make_folder(directory_);
  collection_ = directory_ / (stem_ + ".pvd");
}

void FrameWriter::add(const solver::Frame& frame) {
  check(frame);
  if (!times_.empty() && frame.time <= times_.back()) return;
  if (times_.empty()) {
    records::write_file_atomically(directory_ / (stem_ + "_walls.vtp"),
                                   vtk_points(frame.wall_x, frame.wall_z, "", ""));
    records::write_file_atomically(directory_ / (stem_ + "_outlines.vtp"),
                                   vtk_shapes(outlines(scene_)));
    records::write_file_atomically(directory_ / (stem_ + "_gauges.vtp"),
                                   vtk_shapes(gauges(scene_, gauges_)));
  }
  records::write_file_atomically(directory_ / fmt::format("{}_{:06}.vtp", stem_, times_.size()),
                                 frame_file(frame));
  times_.push_back(frame.time);

  std::string collection = vtk_header("Collection") + "<Collection>\n";
  for (std::size_t k = 0; k < times_.size(); ++k) {
    collection += fmt::format(
        "<DataSet timestep=\"{0}\" part=\"0\" name=\"debris\" file=\"{1}_{2:06}.vtp\"/>\n"
        "<DataSet timestep=\"{0}\" part=\"1\" name=\"walls\" file=\"{1}_walls.vtp\"/>\n"
        "<DataSet timestep=\"{0}\" part=\"2\" name=\"outlines\" file=\"{1}_outlines.vtp\"/>\n"
        "<DataSet timestep=\"{0}\" part=\"3\" name=\"gauges\" file=\"{1}_gauges.vtp\"/>\n",
        times_[k], stem_, k);
  }
  records::write_file_atomically(collection_, collection + "</Collection>\n</VTKFile>\n");
}

}  // namespace parapet::reports
