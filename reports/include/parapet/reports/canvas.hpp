/// A drawing surface in pixels, y downwards: the only place that talks to cairo.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace parapet::reports {

/// A colour with its opacity.
struct Color {
  double red = 0.0, green = 0.0, blue = 0.0, alpha = 1.0;  ///< 0..1
};

/// A place on the page, from the upper left corner.
struct Pixel {
  double x = 0.0, y = 0.0;
};

/// An upright rectangle on the page.
struct PixelBox {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;

  /// Its right edge.
  double right() const { return left + width; }

  /// Its lower edge.
  double bottom() const { return top + height; }
};

/// How a line is drawn; width in pixels.
struct Pen {
  Color color;
  double width = 1.0;
  std::vector<double> dashes;  ///< lengths on and off; empty for a full line
};

/// Which part of the text lies at the given place.
enum class AlignX { left, center, right };

/// The same up and down.
enum class AlignY { top, middle, bottom };

/// How words are drawn; size in pixels.
struct TextStyle {
  double size = 14.0;
  Color color;
  bool bold = false;
  AlignX align_x = AlignX::left;
  AlignY align_y = AlignY::middle;
  double angle = 0.0;  ///< clockwise on the page [rad]
};

/// A page to draw on; it becomes a file with save().
class Canvas {
 public:
  /// @param path ends in .png or .svg; nothing is written before save().
  /// @throws std::invalid_argument for another ending or a size out of 64..16384 pixels.
  Canvas(const std::filesystem::path& path, int width, int height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// An open line through the points.
  void polyline(const std::vector<Pixel>& points, const Pen& pen);

  /// The inside of a closed line through the points.
  void fill_polygon(const std::vector<Pixel>& points, const Color& color);

  /// A closed line through the points.
  void outline_polygon(const std::vector<Pixel>& points, const Pen& pen);

  /// The inside of a box.
  void fill_box(const PixelBox& box, const Color& color);

  /// The edges of a box.
  void outline_box(const PixelBox& box, const Pen& pen);

  /// A filled circle.
  void disc(Pixel center, double radius, const Color& color);

  /// Words at a place; the style says which part of them lies there.
  void text(Pixel at, const std::string& words, const TextStyle& style);

  /// Width that the words would take [pixels].
  double text_width(const std::string& words, const TextStyle& style);

  /// Until unclip(), nothing is drawn out of the box (clips nest).
  void clip(const PixelBox& box);

  /// Undoes the last clip().
  void unclip();

  /// Writes the file in one step: it is either complete or not there.
  /// @throws FileError naming the file that cannot be written.
  void save();

 private:
  struct Surface;
  std::unique_ptr<Surface> surface_;
};

}  // namespace parapet::reports
