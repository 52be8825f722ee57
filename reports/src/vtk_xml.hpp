/// VTK's XML files of points, lines and polygons (PolyData), compressed by zlib.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parapet/solver/vec2.hpp"

namespace parapet::reports {

/// The opening of a file of that type.
std::string vtk_header(std::string_view type);

/// One inline binary array, of single-precision numbers or of whole numbers.
std::string vtk_array(std::string_view name, int components, const std::vector<float>& values);
std::string vtk_array(std::string_view name, int components,
                      const std::vector<std::int32_t>& values);

/// Three components per point; the channel's plane is VTK's x-y plane, so that it faces the viewer.
std::vector<float> vtk_vectors(std::span<const double> x, std::span<const double> z);

/// Lines or polygons through points that are theirs alone.
struct VtkShapes {
  std::vector<std::vector<solver::Vec2>> lines, polygons;
  /// One number per shape under this name, lines first.
  std::string_view name;
  std::vector<std::int32_t> numbers;
};

/// A PolyData file of points, one vertex cell each.
std::string vtk_points(std::span<const double> x, std::span<const double> z,
                       std::string_view field_data, std::string_view point_data);

/// A PolyData file of lines and polygons.
std::string vtk_shapes(const VtkShapes& shapes);

}  // namespace parapet::reports
