// See path_plot.h. Both views have one scale; lines of the room are where the view's plane cuts it, lines of the path
// are projected onto that plane.
#include "tool/path_plot.h"

#include <algorithm>
#include <cmath>

#include "report/profile_plot.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

constexpr double page = 900, margin = 30, title_height = 50, gap = 40, caption = 18, legend = 70, view_height = 420;
constexpr size_t drawn_contributions = 6;
constexpr Ink eye_ink = plane_ink[0], light_ink = plane_ink[1], joined_ink = plane_ink[2];

// Horizontal axis and vertical axis on paper, and the plane's normal.
struct View {
  double across[3], up[3], normal[3];

  Point flat(const double* p) const {
    return {p[0] * across[0] + p[1] * across[1] + p[2] * across[2], p[0] * up[0] + p[1] * up[1] + p[2] * up[2]};
  }
};

// Extent of what a view shows, m.
struct Extent {
  double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
  void grow(const Point& p) {
    left = std::min(left, p.x), right = std::max(right, p.x);
    low = std::min(low, p.y), high = std::max(high, p.y);
  }
  double width() const { return std::max(right - left, 1e-6); }
  double height() const { return std::max(high - low, 1e-6); }
};

class Plot {
 public:
  Plot(const ups_scene* scene, const std::vector<ups_path_vertex>& vertices,
       const std::vector<ups_path_contribution>& contributions)
      : scene_(scene), vertices_(drawn_of(vertices, contributions)), contributions_(contributions) {
    for (const ups_path_vertex& v : vertices_)
      for (int i = 0; i < 3; ++i) centre_[i] += v.position_m[i] / double(vertices_.size());
    // The horizontal direction in which the path reaches farthest from its start.
    double farthest = 0;
    for (const ups_path_vertex& v : vertices_) {
      const double x = v.position_m[0] - vertices_[0].position_m[0], y = v.position_m[1] - vertices_[0].position_m[1];
      if (std::hypot(x, y) > farthest) farthest = std::hypot(x, y), along_[0] = x / farthest, along_[1] = y / farthest;
    }
    if (along_[0] < 0) along_[0] = -along_[0], along_[1] = -along_[1];
  }

  Drawing draw(const std::string& title) {
    const View plan{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const View section{{along_[0], along_[1], 0}, {0, 0, 1}, {-along_[1], along_[0], 0}};
    prepare(plan), prepare(section);
    const double scale = std::min((page - 2 * margin - gap) / (extents_[0].width() + extents_[1].width()),
                                  view_height / std::max(extents_[0].height(), extents_[1].height()));
    const double tallest = std::max(extents_[0].height(), extents_[1].height()) * scale;
    drawing_.width = page;
    drawing_.height = title_height + caption + tallest + legend + margin;
    drawing_.add(Area{{{0, 0}, {page, 0}, {page, drawing_.height}, {0, drawing_.height}}, {255, 255, 255}});
    drawing_.add(Label{{margin, 32}, title, 15, black, Anchor::start, true});
    draw(plan, 0, {margin, title_height + caption}, scale,
         format("Plan, cut at a height of %.3g m", centre_[2]));
    draw(section, 1, {margin + extents_[0].width() * scale + gap, title_height + caption}, scale,
         "Section along the path");
    draw_legend(title_height + caption + tallest + 30, scale);
    return std::move(drawing_);
  }

 private:
  // The sample's own walk, and the light paths of the contributions that are drawn.
  static std::vector<ups_path_vertex> drawn_of(const std::vector<ups_path_vertex>& vertices,
                                               const std::vector<ups_path_contribution>& contributions) {
    std::vector<ups_path_vertex> out;
    const auto end = contributions.begin() + ptrdiff_t(std::min(drawn_contributions, contributions.size()));
    for (const ups_path_vertex& v : vertices)
      if (v.walk == 0 ||
          std::any_of(contributions.begin(), end, [&](const ups_path_contribution& c) { return c.walk == v.walk; }))
        out.push_back(v);
    return out;
  }
  // Its cut of the room, and all that it shows.
  void prepare(const View& view) {
    cuts_.push_back(read_array<ups_segment>([&](ups_segment* to, size_t capacity, size_t* needed) {
      return ups_scene_read_section(scene_, centre_, view.normal, to, capacity, needed);
    }));
    Extent e;
    for (const ups_segment& s : cuts_.back()) e.grow(view.flat(s.from_m)), e.grow(view.flat(s.to_m));
    for (const ups_path_vertex& v : vertices_) e.grow(view.flat(v.position_m));
    extents_.push_back(e);
  }

  void draw(const View& view, size_t index, const Point& corner, double scale, const std::string& name) {
    const Extent& e = extents_[index];
    const auto place = [&](const double* p) {
      const Point flat = view.flat(p);
      return Point{corner.x + (flat.x - e.left) * scale, corner.y + (e.high - flat.y) * scale};
    };
    drawing_.add(Label{{corner.x, corner.y - 6}, name, 12, grey});
    for (const ups_segment& s : cuts_[index])
      drawing_.add(Line{{place(s.from_m), place(s.to_m)}, grey, 1.2});
    for (size_t i = std::min(drawn_contributions, contributions_.size()); i-- > 0;) {
      const ups_path_contribution& c = contributions_[i];
      const Point from = place(c.from_m), to = place(c.to_m);
      if (std::equal(c.from_m, c.from_m + 3, c.to_m)) continue;
      drawing_.add(Line{{from, to}, joined_ink, i == 0 ? 2.0 : 1.0, 3});
    }
    for (size_t i = 1; i < vertices_.size(); ++i)
      if (vertices_[i].walk == vertices_[i - 1].walk)
        drawing_.add(Line{{place(vertices_[i - 1].position_m), place(vertices_[i].position_m)},
                                      ink(vertices_[i]), vertices_[i].walk == 0 ? 1.8 : 1.2});
    std::vector<Point> named;
    for (size_t i = 0, number = 0; i < vertices_.size(); ++i, ++number) {
      if (i > 0 && vertices_[i].walk != vertices_[i - 1].walk) number = 0;
      dot(place(vertices_[i].position_m), ink(vertices_[i]), number == 0 ? 4.5 : 3);
      const Point at = place(vertices_[i].position_m);
      if (vertices_[i].walk == 0 && is_free(at, named))
        drawing_.add(Label{{at.x + 5, at.y - 5}, std::to_string(number), 11, ink(vertices_[i])});
    }
  }

  // Far enough from the names before for one of its own.
  static bool is_free(const Point& at, std::vector<Point>& named) {
    for (const Point& p : named)
      if (std::hypot(p.x - at.x, p.y - at.y) < 14) return false;
    named.push_back(at);
    return true;
  }

  // The sample's own walk may be a light path.
  Ink ink(const ups_path_vertex& v) const {
    const bool eye = v.walk == 0 && !(contributions_.size() > 0 && is_of_light(contributions_[0]));
    return eye ? eye_ink : light_ink;
  }
  static bool is_of_light(const ups_path_contribution& c) {
    return c.technique == UPS_TECHNIQUE_SENSOR_CONNECT || c.technique == UPS_TECHNIQUE_SENSOR_HIT ||
           (c.technique == UPS_TECHNIQUE_MERGE && c.light_path == UINT32_MAX);
  }

  void dot(const Point& at, const Ink& ink, double radius) {
    Area area{{}, ink};
    constexpr int corners = 16;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * 3.14159265358979 * k / corners;
      area.points.push_back({at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)});
    }
    drawing_.add(area);
  }

  void draw_legend(double y, double scale) {
    const struct {
      const char* text;
      Ink ink;
      double dash;
    } entries[] = {{"eye path, from its numbered 0", eye_ink, 0},
                   {"light paths, from the large dot", light_ink, 0},
                   {"edges made between them, the largest bold", joined_ink, 3},
                   {"the room", grey, 0}};
    double x = margin;
    for (const auto& e : entries) {
      drawing_.add(Line{{{x, y - 4}, {x + 30, y - 4}}, e.ink, 2, e.dash});
      drawing_.add(Label{{x + 36, y}, e.text, 11, black});
      x += 36 + width_of(e.text, 11) + 18;
    }
    const double metre = round_step(60 / scale);
    drawing_.add(Line{{{margin, y + 20}, {margin + metre * scale, y + 20}}, black, 2});
    drawing_.add(Label{{margin + metre * scale + 6, y + 24}, format("%g m", metre), 11, black});
  }

  const ups_scene* scene_;
  const std::vector<ups_path_vertex> vertices_;
  const std::vector<ups_path_contribution>& contributions_;
  double centre_[3] = {}, along_[2] = {1, 0};
  std::vector<std::vector<ups_segment>> cuts_;
  std::vector<Extent> extents_;
  Drawing drawing_;
};

}  // namespace

Drawing plot_of(const ups_scene* scene, const std::vector<ups_path_vertex>& vertices,
                const std::vector<ups_path_contribution>& contributions, const std::string& title) {
  return Plot(scene, vertices, contributions).draw(title);
}

}  // namespace ups::tool
