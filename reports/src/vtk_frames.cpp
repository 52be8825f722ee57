#include "parapet/reports/vtk_frames.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "base64.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/file_name.hpp"

namespace parapet::reports {
namespace {

constexpr std::string_view byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

std::string file_header(std::string_view type) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"{}\" "
      "header_type=\"UInt64\">\n",
      type, byte_order);
}

template <typename T>
constexpr std::string_view vtk_type() {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, std::int32_t>);
  return std::is_same_v<T, float> ? "Float32" : "Int32";
}

/// One inline binary array: the byte count as UInt64 and the numbers, in one base64 stream.
template <typename T>
std::string data_array(std::string_view name, int components, const std::vector<T>& values) {
  const std::uint64_t size = values.size() * sizeof(T);
  std::vector<std::byte> bytes(sizeof(size) + size);
  std::memcpy(bytes.data(), &size, sizeof(size));
  if (size > 0) std::memcpy(bytes.data() + sizeof(size), values.data(), size);
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}"
      "</DataArray>\n",
      vtk_type<T>(), name, components, base64(bytes));
}

/// Three components per point; the channel's plane is VTK's x-y plane, so that it faces the viewer.
std::vector<float> plane_vectors(std::span<const double> x, std::span<const double> z) {
  std::vector<float> values(3 * x.size(), 0.0F);
  for (std::size_t k = 0; k < x.size(); ++k) {
    values[3 * k] = static_cast<float>(x[k]);
    values[3 * k + 1] = static_cast<float>(z[k]);
  }
  return values;
}

std::vector<float> scalars(std::span<const double> values) {
  std::vector<float> copy(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) copy[k] = static_cast<float>(values[k]);
  return copy;
}

/// A PolyData file of points, one vertex cell each.
std::string point_cloud(std::span<const double> x, std::span<const double> z,
                        std::string_view field_data, std::string_view point_data) {
  std::vector<std::int32_t> connectivity(x.size());
  std::iota(connectivity.begin(), connectivity.end(), 0);
  std::vector<std::int32_t> offsets(x.size());
  std::iota(offsets.begin(), offsets.end(), 1);
  return fmt::format(
      "{}<PolyData>\n{}<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n{}</PointData>\n"
      "<Points>\n{}</Points>\n<Verts>\n{}{}</Verts>\n</Piece>\n</PolyData>\n</VTKFile>\n",
      file_header("PolyData"), field_data, x.size(), x.size(), point_data,
      data_array("position_m", 3, plane_vectors(x, z)), data_array("connectivity", 1, connectivity),
      data_array("offsets", 1, offsets));
}

std::string frame_file(const solver::Frame& frame) {
  const std::string time = fmt::format(
      "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n</FieldData>\n",
      frame.time);
  const std::vector<std::int32_t> ids(frame.id.begin(), frame.id.end());
  const std::string fields = data_array("velocity_m_s", 3, plane_vectors(frame.u, frame.w)) +
                             data_array("pressure_pa", 1, scalars(frame.pressure)) +
                             data_array("density_kg_m3", 1, scalars(frame.density)) +
                             data_array("viscosity_pa_s", 1, scalars(frame.viscosity)) +
                             data_array("id", 1, ids);
  return point_cloud(frame.x, frame.z, time, fields);
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

FrameWriter::FrameWriter(std::filesystem::path directory, const std::string& case_name)
    : directory_(std::move(directory)), stem_(records::file_name(case_name)) {
  if (case_name.empty()) throw std::invalid_argument("frames need a case name");
  records::make_folder(directory_);
  collection_ = directory_ / (stem_ + ".pvd");
}

void FrameWriter::add(const solver::Frame& frame) {
  check(frame);
  if (!times_.empty() && frame.time <= times_.back()) return;
  if (times_.empty()) {
    records::write_file_atomically(directory_ / (stem_ + "_walls.vtp"),
                                   point_cloud(frame.wall_x, frame.wall_z, "", ""));
  }
  records::write_file_atomically(directory_ / fmt::format("{}_{:06}.vtp", stem_, times_.size()),
                                 frame_file(frame));
  times_.push_back(frame.time);

  std::string collection = file_header("Collection") + "<Collection>\n";
  for (std::size_t k = 0; k < times_.size(); ++k) {
    collection += fmt::format(
        "<DataSet timestep=\"{0}\" part=\"0\" name=\"debris\" file=\"{1}_{2:06}.vtp\"/>\n"
        "<DataSet timestep=\"{0}\" part=\"1\" name=\"walls\" file=\"{1}_walls.vtp\"/>\n",
        times_[k], stem_, k);
  }
  records::write_file_atomically(collection_, collection + "</Collection>\n</VTKFile>\n");
}

}  // namespace parapet::reports
