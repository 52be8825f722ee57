#include "vtk_xml.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <numeric>
#include <type_traits>

#include "base64.hpp"
#include "parapet/records/deflate.hpp"

namespace parapet::reports {
namespace {

constexpr std::string_view byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

template <typename T>
constexpr std::string_view vtk_type() {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, std::int32_t>);
  return std::is_same_v<T, float> ? "Float32" : "Int32";
}

/// One inline binary array as VTK compresses it: a header of 64-bit numbers (blocks, bytes of a
/// block, bytes of a partial last one, bytes of each block compressed), then one block; each in a
/// base64 stream of its own.
template <typename T>
std::string array_of(std::string_view name, int components, const std::vector<T>& values) {
  std::vector<std::uint64_t> header{0, 0, 0};
  std::string block;
  if (!values.empty()) {
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(values.data()),
                          values.size() * sizeof(T));
    block = records::deflated(bytes);
    header = {1, bytes.size(), 0, block.size()};
  }
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}{}"
      "</DataArray>\n",
      vtk_type<T>(), name, components, base64(std::as_bytes(std::span(header))),
      base64(std::as_bytes(std::span(block))));
}

/// Cells of one kind: which points each goes through.
struct Cells {
  std::vector<std::int32_t> connectivity, offsets;
};

std::string cells_text(std::string_view kind, const Cells& cells) {
  return fmt::format("<{0}>\n{1}{2}</{0}>\n", kind,
                     vtk_array("connectivity", 1, cells.connectivity),
                     vtk_array("offsets", 1, cells.offsets));
}

std::string poly_data(const std::vector<float>& points, const std::array<Cells, 3>& cells,
                      std::string_view field_data, std::string_view point_data,
                      std::string_view cell_data) {
  const auto& [verts, lines, polygons] = cells;
  return fmt::format(
      "{}<PolyData>\n{}<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n<PointData>\n{}</PointData>\n"
      "<CellData>\n{}</CellData>\n<Points>\n{}</Points>\n{}{}{}</Piece>\n</PolyData>\n"
      "</VTKFile>\n",
      vtk_header("PolyData"), field_data, points.size() / 3, verts.offsets.size(),
      lines.offsets.size(), polygons.offsets.size(), point_data, cell_data,
      vtk_array("position_m", 3, points), cells_text("Verts", verts), cells_text("Lines", lines),
      cells_text("Polys", polygons));
}

}  // namespace

std::string vtk_header(std::string_view type) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"{}\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n",
      type, byte_order);
}

std::string vtk_array(std::string_view name, int components, const std::vector<float>& values) {
  return array_of(name, components, values);
}

std::string vtk_array(std::string_view name, int components,
                      const std::vector<std::int32_t>& values) {
  return array_of(name, components, values);
}

std::vector<float> vtk_vectors(std::span<const double> x, std::span<const double> z) {
  std::vector<float> values(3 * x.size(), 0.0F);
  for (std::size_t k = 0; k < x.size(); ++k) {
    values[3 * k] = static_cast<float>(x[k]);
    values[3 * k + 1] = static_cast<float>(z[k]);
  }
  return values;
}

std::string vtk_points(std::span<const double> x, std::span<const double> z,
                       std::string_view field_data, std::string_view point_data) {
  std::array<Cells, 3> cells;
  cells[0].connectivity.resize(x.size());
  std::iota(cells[0].connectivity.begin(), cells[0].connectivity.end(), 0);
  cells[0].offsets.resize(x.size());
  std::iota(cells[0].offsets.begin(), cells[0].offsets.end(), 1);
  return poly_data(vtk_vectors(x, z), cells, field_data, point_data, "");
}

std::string vtk_shapes(const VtkShapes& shapes) {
  std::vector<double> x, z;
  std::array<Cells, 3> cells;
  const auto add = [&](Cells& kind, const std::vector<solver::Vec2>& corners) {
    for (const solver::Vec2& corner : corners) {
      kind.connectivity.push_back(static_cast<std::int32_t>(x.size()));
      x.push_back(corner.x);
      z.push_back(corner.z);
    }
    kind.offsets.push_back(static_cast<std::int32_t>(kind.connectivity.size()));
  };
  for (const auto& line : shapes.lines) add(cells[1], line);
  for (const auto& polygon : shapes.polygons) add(cells[2], polygon);
  return poly_data(vtk_vectors(x, z), cells, "", "", vtk_array(shapes.name, 1, shapes.numbers));
}

}  // namespace parapet::reports
