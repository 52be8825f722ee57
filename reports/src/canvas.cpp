#include "parapet/reports/canvas.hpp"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

#include "parapet/records/atomic_file.hpp"

namespace parapet::reports {
namespace {

constexpr const char* font_family = "DejaVu Sans";
constexpr double cap_height = 0.73;  // of DejaVu Sans, as a share of the font's size
constexpr double descent = 0.21;

cairo_status_t append_bytes(void* target, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void set_color(cairo_t* context, const Color& color) {
  cairo_set_source_rgba(context, color.red, color.green, color.blue, color.alpha);
}

void set_pen(cairo_t* context, const Pen& pen) {
  set_color(context, pen.color);
  cairo_set_line_width(context, pen.width);
  cairo_set_dash(context, pen.dashes.data(), static_cast<int>(pen.dashes.size()), 0.0);
}

void set_font(cairo_t* context, const TextStyle& style) {
  cairo_select_font_face(context, font_family, CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size);
}

void trace(cairo_t* context, const std::vector<Pixel>& points) {
  cairo_new_path(context);
  for (const Pixel& point : points) cairo_line_to(context, point.x, point.y);
}

}  // namespace

struct Canvas::Surface {
  std::filesystem::path path;
  bool svg = false;
  std::string bytes;  // what cairo has written so far
  cairo_surface_t* surface = nullptr;
  cairo_t* context = nullptr;

  ~Surface() {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }
};

Canvas::Canvas(const std::filesystem::path& path, int width, int height) {
  const std::string ending = path.extension().string();
  if (ending != ".png" && ending != ".svg") {
    throw std::invalid_argument(
        fmt::format("{}: a picture's name must end in .png or .svg", path.string()));
  }
  if (width < 64 || width > 16384 || height < 64 || height > 16384) {
    throw std::invalid_argument(
        fmt::format("{}: a picture of {} x {} pixels; allowed: 64 to 16384 each way", path.string(),
                    width, height));
  }
  surface_ = std::make_unique<Surface>();
  surface_->path = path;
  surface_->svg = ending == ".svg";
  if (surface_->svg) {
    surface_->surface =
        cairo_svg_surface_create_for_stream(append_bytes, &surface_->bytes, width, height);
    cairo_svg_surface_set_document_unit(surface_->surface, CAIRO_SVG_UNIT_PX);
  } else {
    surface_->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  }
  surface_->context = cairo_create(surface_->surface);
  cairo_set_line_join(surface_->context, CAIRO_LINE_JOIN_ROUND);
  fill_box({0.0, 0.0, static_cast<double>(width), static_cast<double>(height)},
           {1.0, 1.0, 1.0, 1.0});
}

Canvas::~Canvas() = default;

void Canvas::polyline(const std::vector<Pixel>& points, const Pen& pen) {
  trace(surface_->context, points);
  set_pen(surface_->context, pen);
  cairo_stroke(surface_->context);
}

void Canvas::fill_polygon(const std::vector<Pixel>& points, const Color& color) {
  trace(surface_->context, points);
  cairo_close_path(surface_->context);
  set_color(surface_->context, color);
  cairo_fill(surface_->context);
}

void Canvas::outline_polygon(const std::vector<Pixel>& points, const Pen& pen) {
  trace(surface_->context, points);
  cairo_close_path(surface_->context);
  set_pen(surface_->context, pen);
  cairo_stroke(surface_->context);
}

void Canvas::fill_box(const PixelBox& box, const Color& color) {
  cairo_new_path(surface_->context);
  cairo_rectangle(surface_->context, box.left, box.top, box.width, box.height);
  set_color(surface_->context, color);
  cairo_fill(surface_->context);
}

void Canvas::outline_box(const PixelBox& box, const Pen& pen) {
  cairo_new_path(surface_->context);
  cairo_rectangle(surface_->context, box.left, box.top, box.width, box.height);
  set_pen(surface_->context, pen);
  cairo_stroke(surface_->context);
}

void Canvas::disc(Pixel center, double radius, const Color& color) {
  cairo_new_path(surface_->context);
  cairo_arc(surface_->context, center.x, center.y, radius, 0.0, 2.0 * std::numbers::pi);
  set_color(surface_->context, color);
  cairo_fill(surface_->context);
}

double Canvas::text_width(const std::string& words, const TextStyle& style) {
  set_font(surface_->context, style);
  cairo_text_extents_t extents;
  cairo_text_extents(surface_->context, words.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(Pixel at, const std::string& words, const TextStyle& style) {
  const double width = text_width(words, style);
  double dx = 0.0;
  if (style.align_x == AlignX::center) dx = -0.5 * width;
  if (style.align_x == AlignX::right) dx = -width;
  double dy = 0.5 * cap_height * style.size;
  if (style.align_y == AlignY::top) dy = cap_height * style.size;
  if (style.align_y == AlignY::bottom) dy = -descent * style.size;
  cairo_t* context = surface_->context;
  cairo_save(context);
  cairo_translate(context, at.x, at.y);
  cairo_rotate(context, style.angle);
  set_color(context, style.color);
  cairo_move_to(context, dx, dy);
  cairo_show_text(context, words.c_str());
  cairo_restore(context);
}

void Canvas::clip(const PixelBox& box) {
  cairo_save(surface_->context);
  cairo_new_path(surface_->context);
  cairo_rectangle(surface_->context, box.left, box.top, box.width, box.height);
  cairo_clip(surface_->context);
}

void Canvas::unclip() {
  cairo_restore(surface_->context);
}

void Canvas::save() {
  cairo_surface_flush(surface_->surface);
  cairo_status_t status = cairo_status(surface_->context);
  if (status == CAIRO_STATUS_SUCCESS) {
    if (surface_->svg) {
      cairo_surface_finish(surface_->surface);
      status = cairo_surface_status(surface_->surface);
    } else {
      status = cairo_surface_write_to_png_stream(surface_->surface, append_bytes, &surface_->bytes);
    }
  }
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(fmt::format("{}: the picture cannot be drawn: {}",
                                         surface_->path.string(), cairo_status_to_string(status)));
  }
  records::write_file_atomically(surface_->path, surface_->bytes);
}

}  // namespace parapet::reports
