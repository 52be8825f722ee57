/// Pixels of a PNG file, for tests that look at what was drawn.
#pragma once

#include <cairo.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>

namespace parapet::reports {

class PicturePixels {
 public:
  explicit PicturePixels(const std::filesystem::path& file)
      : surface_(cairo_image_surface_create_from_png(file.c_str())) {
    EXPECT_EQ(cairo_surface_status(surface_), CAIRO_STATUS_SUCCESS) << file;
  }
  ~PicturePixels() { cairo_surface_destroy(surface_); }
  PicturePixels(const PicturePixels&) = delete;
  PicturePixels& operator=(const PicturePixels&) = delete;

  int width() const { return cairo_image_surface_get_width(surface_); }
  int height() const { return cairo_image_surface_get_height(surface_); }

  /// 0xRRGGBB
  std::uint32_t at(int x, int y) const {
    const std::ptrdiff_t stride = cairo_image_surface_get_stride(surface_);
    const unsigned char* row = cairo_image_surface_get_data(surface_) + y * stride;
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, row + std::ptrdiff_t{4} * x, 4);
    return pixel & 0xFFFFFFU;
  }

  std::size_t colors() const {
    std::set<std::uint32_t> seen;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) seen.insert(at(x, y));
    }
    return seen.size();
  }

  /// Number and centre of the pixels of exactly this colour left of a limit.
  struct Patch {
    int count = 0;
    double x = 0.0, y = 0.0;
  };
  Patch patch(std::uint32_t color, int from, int to) const {
    Patch found;
    for (int y = 0; y < height(); ++y) {
      for (int x = from; x < to; ++x) {
        if (at(x, y) != color) continue;
        ++found.count;
        found.x += x + 0.5;
        found.y += y + 0.5;
      }
    }
    if (found.count > 0) {
      found.x /= found.count;
      found.y /= found.count;
    }
    return found;
  }

 private:
  cairo_surface_t* surface_;
};

}  // namespace parapet::reports
