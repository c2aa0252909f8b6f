// A drawing on a surface of Cairo: pixels, a page, or the elements of an SVG document (drawing_svg.cpp finishes those).
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>

#include "common/boundary.h"
#include "report/drawing.h"
#include "report/drawing_svg.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

constexpr const char* family = "sans-serif";

struct Destroy {
  void operator()(cairo_t* c) const { cairo_destroy(c); }
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
  void operator()(cairo_font_options_t* o) const { cairo_font_options_destroy(o); }
  void operator()(cairo_font_face_t* f) const { cairo_font_face_destroy(f); }
  void operator()(cairo_scaled_font_t* f) const { cairo_scaled_font_destroy(f); }
};
template <class Object>
using Owned = std::unique_ptr<Object, Destroy>;

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("the drawing cannot be made: ") + cairo_status_to_string(status));
}

// Without hints a text is as wide on each surface and at each size.
Owned<cairo_font_options_t> font_options() {
  Owned<cairo_font_options_t> options(cairo_font_options_create());
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  return options;
}

class Canvas {
 public:
  Canvas(cairo_surface_t* surface, double zoom) : cairo_(cairo_create(surface)) {
    check(cairo_status(c()));
    cairo_scale(c(), zoom, zoom);
    cairo_set_line_cap(c(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(c(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_fill_rule(c(), CAIRO_FILL_RULE_EVEN_ODD);
    cairo_set_font_options(c(), font_options().get());
    cairo_set_source_rgb(c(), 1, 1, 1);
    cairo_paint(c());
  }

  void draw(const Line& line) {
    if (line.points.empty()) return;
    trace(line.points);
    if (line.points.size() == 1) cairo_line_to(c(), line.points[0].x, line.points[0].y);  // a dot
    const double dashes[2] = {line.dash, line.dash * Line::gap};
    cairo_set_dash(c(), dashes, line.dash > 0 ? 2 : 0, 0);
    cairo_set_line_cap(c(), line.dash > 0 ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
    cairo_set_line_width(c(), line.width);
    take(line.ink, line.opacity);
    cairo_stroke(c());
  }

  void draw(const Area& area) {
    trace(area.points);
    cairo_close_path(c());
    take(area.ink, area.opacity);
    cairo_fill(c());
  }

  void draw(const Label& label) {
    const std::string text = writable(label.text);
    if (text.empty()) return;
    const double width = width_of(text, label.size, label.bold);
    const double before = label.anchor == Anchor::middle ? 0.5 * width : label.anchor == Anchor::end ? width : 0;
    cairo_save(c());
    cairo_translate(c(), label.at.x, label.at.y);
    if (label.turn_rad != 0) cairo_rotate(c(), label.turn_rad);
    cairo_select_font_face(c(), family, CAIRO_FONT_SLANT_NORMAL,
                           label.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(c(), label.size);
    if (label.halo > 0) {
      cairo_move_to(c(), -before, 0);
      cairo_text_path(c(), text.c_str());
      cairo_set_dash(c(), nullptr, 0, 0);
      cairo_set_line_width(c(), 2 * label.halo);
      cairo_set_source_rgba(c(), 1, 1, 1, 0.85);
      cairo_stroke(c());
    }
    cairo_move_to(c(), -before, 0);
    take(label.ink, 1);
    cairo_show_text(c(), text.c_str());
    cairo_restore(c());
    cairo_new_path(c());
  }

  void draw(const Picture& picture) {
    const auto pixels = pixels_of(picture);
    cairo_save(c());
    cairo_translate(c(), picture.corner.x, picture.corner.y);
    cairo_scale(c(), picture.width / picture.columns, picture.height / picture.rows);
    cairo_set_source_surface(c(), pixels.get(), 0, 0);
    cairo_pattern_set_extend(cairo_get_source(c()), CAIRO_EXTEND_PAD);  // or edges fade into nothing
    if (picture.crisp) cairo_pattern_set_filter(cairo_get_source(c()), CAIRO_FILTER_NEAREST);
    cairo_rectangle(c(), 0, 0, picture.columns, picture.rows);
    cairo_clip(c());
    cairo_paint(c());
    cairo_restore(c());
  }

  void draw(const ClipBegin& clip) {
    cairo_save(c());
    cairo_new_path(c());
    for (const auto& outline : clip.outlines) {
      trace(outline);
      cairo_close_path(c());
    }
    cairo_clip(c());
  }
  void draw(const ClipEnd&) { cairo_restore(c()); }

  void finish() const { check(cairo_status(c())); }

 private:
  cairo_t* c() const { return cairo_.get(); }

  void trace(const std::vector<Point>& points) {
    for (size_t i = 0; i < points.size(); ++i)
      (i == 0 ? cairo_move_to : cairo_line_to)(c(), points[i].x, points[i].y);
  }

  void take(const Ink& ink, double opacity) {
    cairo_set_source_rgba(c(), ink[0] / 255.0, ink[1] / 255.0, ink[2] / 255.0, opacity);
  }

  static Owned<cairo_surface_t> pixels_of(const Picture& picture) {
    Owned<cairo_surface_t> surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, int(picture.columns), int(picture.rows)));
    check(cairo_surface_status(surface.get()));
    unsigned char* bytes = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (uint32_t y = 0; y < picture.rows; ++y) {
      auto* row = reinterpret_cast<uint32_t*>(bytes + size_t(y) * size_t(stride));
      for (uint32_t x = 0; x < picture.columns; ++x) {
        const uint8_t* from = &picture.rgba[4 * (size_t(y) * picture.columns + x)];
        const uint32_t alpha = from[3];
        const auto part = [&](int k) { return (from[k] * alpha + 127) / 255; };  // Cairo's are multiplied by alpha
        row[x] = alpha << 24 | part(0) << 16 | part(1) << 8 | part(2);
      }
    }
    cairo_surface_mark_dirty(surface.get());
    return surface;
  }

  Owned<cairo_t> cairo_;
};

void draw(const Drawing& drawing, cairo_surface_t* surface, double zoom) {
  Canvas canvas(surface, zoom);
  for (const auto& part : drawing.parts) std::visit([&](const auto& p) { canvas.draw(p); }, part);
  canvas.finish();
}

// Writes what is left.
void finish(cairo_surface_t* surface) {
  cairo_surface_finish(surface);
  check(cairo_surface_status(surface));
}

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int size) {
  try {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), size);
    return CAIRO_STATUS_SUCCESS;
  } catch (...) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

// Of an em of 1.
Owned<cairo_scaled_font_t> scaled_font(bool bold) {
  const Owned<cairo_font_face_t> face(cairo_toy_font_face_create(
      family, CAIRO_FONT_SLANT_NORMAL, bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL));
  cairo_matrix_t size, identity;
  cairo_matrix_init_scale(&size, 1, 1);
  cairo_matrix_init_identity(&identity);
  Owned<cairo_scaled_font_t> font(cairo_scaled_font_create(face.get(), &size, &identity, font_options().get()));
  check(cairo_scaled_font_status(font.get()));
  return font;
}

}  // namespace

std::string writable(const std::string& text) {
  std::string out;
  for (size_t i = 0; i < text.size();) {
    const Utf8 character = utf8_at(text, i);
    const bool good = character.length > 0 && character.code >= 0x20 && character.code != 0xfffe &&
                      character.code != 0xffff;
    out += good ? text.substr(i, character.length) : "?";
    i += character.length == 0 ? 1 : character.length;
  }
  return out;
}

void Drawing::add(Part part) { parts.push_back(std::move(part)); }

double width_of(const std::string& text, double size, bool bold) {
  const auto font = scaled_font(bold);  // Cairo keeps it; one of our own would keep an error, too
  cairo_text_extents_t extents;
  cairo_scaled_font_text_extents(font.get(), writable(text).c_str(), &extents);
  check(cairo_scaled_font_status(font.get()));
  return extents.x_advance * size;
}

std::string to_svg_elements(const Drawing& drawing) {
  std::string svg;
  const Owned<cairo_surface_t> surface(
      cairo_svg_surface_create_for_stream(append, &svg, drawing.width, drawing.height));
  check(cairo_surface_status(surface.get()));
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  draw(drawing, surface.get(), 1);
  finish(surface.get());
  return svg;
}

std::string to_png(const Drawing& drawing, double zoom) {
  const int width = int(std::lround(drawing.width * zoom)), height = int(std::lround(drawing.height * zoom));
  extras::ask_for_memory(extras::ample_bytes + size_t(width) * size_t(height) * 16);
  const Owned<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  check(cairo_surface_status(surface.get()));
  draw(drawing, surface.get(), zoom);
  std::string png;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &png));
  return png;
}

std::string to_pdf(const Drawing& drawing, const Words& words) {
  constexpr double points_a_unit = 0.75;
  extras::ask_for_memory(2 * extras::ample_bytes);
  std::string pdf;
  const Owned<cairo_surface_t> surface(cairo_pdf_surface_create_for_stream(
      append, &pdf, drawing.width * points_a_unit, drawing.height * points_a_unit));
  check(cairo_surface_status(surface.get()));
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, writable(words.title).c_str());
  if (!words.description.empty())
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_SUBJECT, writable(words.description).c_str());
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");  // same drawing, same bytes
  draw(drawing, surface.get(), points_a_unit);
  finish(surface.get());
  return pdf;
}

}  // namespace ups::report
