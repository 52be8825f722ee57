/// A drawing surface in pixels, y downwards: the only place that talks to cairo.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace parapet::reports {

struct Color {
  double red = 0.0, green = 0.0, blue = 0.0, alpha = 1.0;  ///< 0..1
};

struct Pixel {
  double x = 0.0, y = 0.0;
};

struct PixelBox {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

struct Pen {
  Color color;
  double width = 1.0;
  std::vector<double> dashes;  ///< lengths on and off; empty for a full line
};

/// Which part of the text lies at the given place.
enum class AlignX { left, center, right };
enum class AlignY { top, middle, bottom };

struct TextStyle {
  double size = 14.0;
  Color color;
  bool bold = false;
  AlignX align_x = AlignX::left;
  AlignY align_y = AlignY::middle;
  double angle = 0.0;  ///< clockwise on the page [rad]
};

class Canvas {
 public:
  /// @param path ends in .png or .svg; nothing is written before save().
  /// @throws std::invalid_argument for another ending or a size out of 64..16384 pixels.
  Canvas(const std::filesystem::path& path, int width, int height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  void polyline(const std::vector<Pixel>& points, const Pen& pen);
  void fill_polygon(const std::vector<Pixel>& points, const Color& color);
  void outline_polygon(const std::vector<Pixel>& points, const Pen& pen);
  void fill_box(const PixelBox& box, const Color& color);
  void outline_box(const PixelBox& box, const Pen& pen);
  void disc(Pixel center, double radius, const Color& color);
  void text(Pixel at, const std::string& words, const TextStyle& style);
  double text_width(const std::string& words, const TextStyle& style);

  /// Until unclip(), nothing is drawn out of the box (clips nest).
  void clip(const PixelBox& box);
  void unclip();

  /// Writes the file in one step: it is either complete or not there.
  /// @throws FileError naming the file that cannot be written.
  void save();

 private:
  struct Surface;
  std::unique_ptr<Surface> surface_;
};

}  // namespace parapet::reports
