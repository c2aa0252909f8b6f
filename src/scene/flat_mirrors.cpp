// See flat_mirrors.h: which surfaces are flat mirrors, and which emitters have images in them.
#include "scene/flat_mirrors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/frame.h"
#include "scene/probe.h"
#include "scene/snapshot.h"

namespace ups {
namespace {

constexpr size_t most_planes_of_instance = 6;       // a slab's
constexpr size_t most_triangles = size_t(1) << 16;  // that are looked at of an instance
constexpr float most_leaning = 1e-4f;               // sine, of normals that are interpolated
constexpr float least_sine = 1e-5f;                 // between a mirror and directional light, which floats tell apart

bool has_image(const Emitter& e) { return e.is_direct() && e.flux_lm() > 0; }

struct Side {  // of triangles
  Vec3d n;
  double offset;
  bool holds(const Vec3d& p, double error) const { return std::abs(dot(n, p) - offset) <= error; }
};

// A plane with what lies in it.
struct Part {
  Side side;
  uint32_t material;
  double rounding;             // of its corners
  std::vector<Vec3d> corners;  // 3 a triangle
  // The farthest along eight directions of the plane: what holds these holds all.
  static constexpr int directions = 8;
  std::array<Vec3d, directions> farthest{};

  void add(const std::array<Vec3d, 3>& triangle) {
    const Frame frame{Vec3(side.n)};
    for (int k = 0; k < directions; ++k) {
      const double angle = k * (2 * double(pi) / directions);
      const Vec3d along = Vec3d(frame.s) * std::cos(angle) + Vec3d(frame.t) * std::sin(angle);
      for (const Vec3d& p : triangle) {
        const bool first = corners.empty() && &p == triangle.data();
        if (first || dot(p, along) > dot(farthest[size_t(k)], along)) farthest[size_t(k)] = p;
      }
    }
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
};

class Search {
 public:
  explicit Search(const Snapshot& scene) : scene_(scene) {}

  FlatMirrors find() {
    for (size_t e = 0; e < scene_.emitters.size(); ++e) {
      const Emitter& emitter = scene_.emitters[e];
      if (!has_image(emitter)) continue;
      (emitter.is_directional() ? suns_ : emitter.is_delta() ? punctual_ : extended_).push_back(uint32_t(e));
    }
    if (suns_.size() + extended_.size() > FlatMirrors::most_weighed) extended_.clear();
    if ((punctual_.empty() && suns_.empty() && extended_.empty()) || scene_.media.nest) return {};
    out_.planes_of_instance.resize(scene_.instances.size());
    for (size_t i = 0; i < scene_.instances.size(); ++i)
      if (!add(i)) others_ |= traits_of(material_of(i)).delta || is_shining_pane(scene_, i);
    leave_out_hidden();
    number_columns();
    choose_planes();
    if (out_.images.empty()) return {};
    judge();
    if (out_.images.size() > FlatMirrors::most_weighed || out_.of_extended) out_.tree = tree_of_images();
    return std::move(out_);
  }

 private:
  const Material& material_of(size_t instance) const { return scene_.materials[scene_.instances[instance].material]; }

  // That reflects by one delta lobe, alike everywhere.
  bool is_mirror(size_t instance) const {
    const Material& m = material_of(instance);
    const SurfaceTexturing& texturing = scene_.texturing[scene_.instances[instance].material];
    return (m.model == MaterialModel::mirror || m.model == MaterialModel::glazing) && !m.reflectance_texture &&
           traits_of(m).delta && !texturing.normal && texturing.alpha_mode == SurfaceTexturing::opaque &&
           scene_.emitter_of_instance[instance] == none;
  }

  // False where the instance is no flat mirror.
  bool add(size_t instance) {
    const Raytracer::Instance& placed = scene_.instances[instance];
    const Mesh& mesh = *scene_.meshes[placed.mesh];
    if (!is_mirror(instance) || mesh.revolution || mesh.triangle_count() > most_triangles) return false;
    const double rounding = rounding_of(mesh, placed.to_scene);
    std::vector<Side> sides;
    std::vector<uint32_t> of_triangle;
    std::vector<std::array<Vec3d, 3>> triangles;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
      std::array<Vec3d, 3> p;
      for (size_t c = 0; c < 3; ++c) p[c] = placed.to_scene.point(Vec3d(mesh.positions[mesh.indices[3 * t + c]]));
      triangles.push_back(p);
      of_triangle.push_back(side_of(p, rounding, sides));
      if (of_triangle.back() == none || leans(mesh, t)) return false;
    }
    if (sides.empty()) return false;
    std::vector<uint32_t> part_of_side;
    for (const Side& side : sides) part_of_side.push_back(part_of(side, rounding, placed.material));
    for (size_t t = 0; t < triangles.size(); ++t) {
      of_triangle[t] = part_of_side[of_triangle[t]];
      parts_[of_triangle[t]].add(triangles[t]);
    }
    if (sides.size() == 1) of_triangle.resize(1);
    out_.planes_of_instance[instance] = std::move(of_triangle);
    return true;
  }

  // How far its vertices may lie off a plane that they were meant to lie in: by their floats, and a little of its size.
  // What bends more is bent, however large the scene is.
  static double rounding_of(const Mesh& mesh, const Affine& to_scene) {
    const Box box = bounding_box(mesh), placed = box.transformed(to_scene);
    const double scale = std::max({length(to_scene.column(0)), length(to_scene.column(1)), length(to_scene.column(2))});
    return 0x1p-22 * scale * std::max(max_abs(box.lower), max_abs(box.upper)) +
           0x1p-20 * length(placed.upper - placed.lower);
  }

  // Of those found so far, or a new one; none: there are too many.
  static uint32_t side_of(const std::array<Vec3d, 3>& p, double rounding, std::vector<Side>& sides) {
    for (size_t i = 0; i < sides.size(); ++i)
      if (std::all_of(p.begin(), p.end(), [&](const Vec3d& q) { return sides[i].holds(q, rounding); }))
        return uint32_t(i);
    const Vec3d n = cross(p[1] - p[0], p[2] - p[0]);
    const double twice_area = length(n);
    if (sides.size() == most_planes_of_instance || !(twice_area > 0)) return none;
    sides.push_back({n / twice_area, dot(n / twice_area, p[0])});
    return uint32_t(sides.size() - 1);
  }

  // Normals of vertices that are not those of the triangle.
  static bool leans(const Mesh& mesh, size_t triangle) {
    if (mesh.normals.empty()) return false;
    const uint32_t* at = &mesh.indices[3 * triangle];
    const Vec3d p(mesh.positions[at[0]]),
        n = normalize(cross(Vec3d(mesh.positions[at[1]]) - p, Vec3d(mesh.positions[at[2]]) - p));
    for (int c = 0; c < 3; ++c)
      if (!(length(cross(n, normalize(Vec3d(mesh.normals[at[c]])))) < most_leaning)) return true;
    return false;
  }

  // Two that lie in one plane and reflect alike are one, so that a point has one image in them.
  uint32_t part_of(const Side& side, double rounding, uint32_t material) {
    for (size_t i = 0; i < parts_.size(); ++i) {
      Part& part = parts_[i];
      const auto is_in = [&](const Vec3d& p) {
        return side.holds(p, std::max(rounding, part.rounding) + 0x1p-23 * max_abs(p));
      };
      constexpr double leaning2 = double(most_leaning) * most_leaning;
      if (part.material == material && length2(cross(part.side.n, side.n)) < leaning2 &&
          is_in(part.side.n * part.side.offset) &&
          std::all_of(part.farthest.begin(), part.farthest.end(), is_in)) {
        part.rounding = std::max(rounding, part.rounding);
        return uint32_t(i);
      }
    }
    parts_.push_back({side, material, rounding, {}, {}});
    return uint32_t(parts_.size() - 1);
  }

  // Along the longest edge, which rectangles have.
  static Frame frame_of(const Part& part) {
    Vec3d longest = part.corners[1] - part.corners[0];
    for (size_t c = 0; c < part.corners.size(); c += 3)
      for (size_t k = 0; k < 3; ++k) {
        const Vec3d edge = part.corners[c + (k + 1) % 3] - part.corners[c + k];
        if (length2(edge) > 1.0001 * length2(longest)) longest = edge;
      }
    const Vec3d s = normalize(longest - part.side.n * dot(longest, part.side.n));
    return {Vec3(s), Vec3(cross(part.side.n, s)), Vec3(part.side.n)};
  }

  static FlatMirrors::Plane plane_of(const Part& part) {
    const Frame frame = frame_of(part);
    FlatMirrors::Plane out{};
    out.n = frame.n, out.s = frame.s, out.t = frame.t;
    out.offset = float(part.side.offset);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (const Vec3d& p : part.corners) {
      const double at[2] = {dot(p, Vec3d(frame.s)), dot(p, Vec3d(frame.t))};
      for (int k = 0; k < 2; ++k) low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
    }
    const double s = 0.5 * (low[0] + high[0]), t = 0.5 * (low[1] + high[1]);
    out.center = Vec3(Vec3d(frame.s) * s + Vec3d(frame.t) * t + Vec3d(frame.n) * part.side.offset);
    const double half_s = 0.5 * (high[0] - low[0]), half_t = 0.5 * (high[1] - low[1]),
                 error = part.rounding + 0x1p-23 * (double(max_abs(out.center)) + half_s + half_t);
    out.half_s = float(half_s + 8 * error), out.half_t = float(half_t + 8 * error);
    out.error = float(error);
    out.material = part.material;
    return out;
  }

  // Lamps behind lenses and in reflectors, of which flat mirrors show nothing.
  void leave_out_hidden() {
    if (!others_ || parts_.empty()) return;
    constexpr uint32_t rays = 64, least_rays = 2;
    const auto is_hidden = [&](uint32_t e) {
      uint32_t open = 0;
      for (uint32_t i = 0; i < rays; ++i) {
        const FirstLight light = first_light(scene_, scene_.emitters[e], i);
        open += !light.hit || traits_of(scene_.materials[light.surface.material]).continuous ||
                !out_.planes_of_instance[light.surface.instance].empty();
      }
      return open < least_rays;
    };
    extended_.erase(std::remove_if(extended_.begin(), extended_.end(), is_hidden), extended_.end());
  }

  // Of the emitters that may have images.
  void number_columns() {
    out_.column_of_emitter.assign(scene_.emitters.size(), none);
    for (const auto* emitters : {&punctual_, &suns_, &extended_})
      for (const uint32_t e : *emitters) out_.column_of_emitter[e] = uint32_t(out_.column_count++);
  }

  // The largest, as far as there may be images in them. Lamps with extent, whose light eye paths find in mirrors anyhow,
  // have some as long as all can be weighed; so has the sun, of which a tree cannot tell which mirror shows it.
  void choose_planes() {
    std::vector<FlatMirrors::Plane> planes;
    std::vector<uint32_t> order;
    for (const Part& part : parts_) order.push_back(uint32_t(order.size())), planes.push_back(plane_of(part));
    const auto area = [&](uint32_t i) { return double(planes[i].half_s) * planes[i].half_t; };
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return area(a) > area(b); });
    const size_t weighed_each = suns_.size() + extended_.size();
    if (punctual_.empty() && weighed_each == 0) return;
    const size_t most = punctual_.empty() ? FlatMirrors::most_weighed / weighed_each
                                          : FlatMirrors::most_images / punctual_.size();
    if (order.size() > most) order.resize(most);
    others_ |= order.size() < parts_.size();
    std::vector<uint32_t> number(parts_.size(), none);
    size_t weighed = order.size() * punctual_.size();
    for (const uint32_t i : order) {
      number[i] = uint32_t(out_.planes.size());
      out_.planes.push_back(planes[i]);
      out_.image_numbers.resize(out_.planes.size() * out_.column_count, none);
      for (const uint32_t e : punctual_) add_image(e, number[i]);
      if ((weighed += weighed_each) > FlatMirrors::most_weighed) {
        others_ |= !suns_.empty();
        continue;
      }
      for (const uint32_t e : suns_) add_image(e, number[i]);
      for (const uint32_t e : extended_) add_image(e, number[i]);
    }
    for (auto& of_triangle : out_.planes_of_instance)
      for (uint32_t& plane : of_triangle) plane = number[plane];
  }

  // Of a lamp on the mirror itself there is none, nor of one that reaches through its plane, nor of light along it.
  void add_image(uint32_t emitter, uint32_t plane) {
    const FlatMirrors::Plane& p = out_.planes[plane];
    const Emitter& e = scene_.emitters[emitter];
    const float reach = e.is_delta() ? 0 : e.reach(p.n);
    const bool far = e.is_directional();
    const Vec3 center = far ? direction_to(e) : e.center();
    if (far ? std::abs(dot(p.n, center)) > least_sine : std::abs(p.height(center)) > reach + 16 * p.error) {
      out_.image_numbers[plane * out_.column_count + out_.column_of_emitter[emitter]] = uint32_t(out_.images.size());
      out_.images.push_back({emitter, plane, center, e.is_delta() ? 0 : e.radius(), reach, far});
      out_.of_extended |= !e.is_delta();
      out_.has[far] = true;
    } else {
      others_ |= e.is_delta();
    }
  }
  static Vec3 direction_to(const Emitter& directional) {
    DirectSample s;
    return directional.sample_direct({}, {0.5f, 0.5f}, s) ? s.wi : Vec3();
  }

  void judge() {
    out_.frequency = 0;  // by what the strongest reflects of light that it faces
    for (const FlatMirrors::Plane& p : out_.planes)
      out_.frequency = std::max(out_.frequency, max_component(mirror_lobe(scene_.materials[p.material], 1).reflectance));
    if (out_.images.size() > FlatMirrors::most_weighed) out_.frequency *= share_of_sight();
    out_.frequency = std::clamp(out_.frequency, 0.05f, 1.0f);
    size_t shining = 0;
    for (size_t e = 0; e < scene_.emitters.size(); ++e) {
      const Emitter& emitter = scene_.emitters[e];
      if (!(emitter.flux_lm() > 0)) continue;
      ++shining;
      others_ |= emitter.is_delta() && !has_image(emitter);
    }
    out_.all_flat = !others_;
    out_.of_all = out_.images.size() == shining * out_.planes.size();
    const auto lies_in_first = [&](const FlatMirrors::Plane& p) {
      const FlatMirrors::Plane& first = out_.planes[0];
      return length(cross(p.n, first.n)) < most_leaning && std::abs(first.height(p.center)) <= 2 * p.error;
    };
    out_.complete = out_.all_flat && std::all_of(out_.planes.begin(), out_.planes.end(), lies_in_first);
  }

  // Roughly, of receivers that see a given image: a tree chooses those that its mirror does not show, too.
  float share_of_sight() const {
    float area = 0;
    for (const FlatMirrors::Plane& p : out_.planes) area = std::max(area, 4 * p.half_s * p.half_t);
    return std::min(1.0f, 2 * area / (3.14159265f * scene_.radius * scene_.radius));
  }

  LightTree tree_of_images() const {
    std::vector<LightTree::Entry> entries;
    for (const FlatMirrors::Image& image : out_.images) {
      const FlatMirrors::Plane& plane = out_.planes[image.plane];
      const Emitter& emitter = scene_.emitters[image.emitter];
      Outline o = emitter.outline();
      o.center = plane.mirrored(o.center);
      o.half = half_of_image(plane, o.half);
      for (Vec3* axis : {&o.frame.s, &o.frame.t, &o.frame.n}) *axis = plane.mirrored_direction(*axis);
      for (Vec3& area : o.areas) area = plane.mirrored_direction(area);
      // Where they are weighed each has its own.
      const float reflectance =
          out_.of_extended ? 1
                           : std::max(0.01f, luminance(mirror_lobe(scene_.materials[plane.material], 0.7f).reflectance));
      entries.push_back({o, emitter.flux_lm() * double(reflectance), reflectance, uint32_t(entries.size())});
    }
    return LightTree(entries, entries.size());
  }

  // Of the box along the axes that holds the image of such a box.
  static Vec3 half_of_image(const FlatMirrors::Plane& plane, const Vec3& half) {
    const auto along = [&](const Vec3& axis) {
      const Vec3 v = plane.mirrored_direction(axis);
      return std::abs(v.x) * half.x + std::abs(v.y) * half.y + std::abs(v.z) * half.z;
    };
    return {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
  }

  const Snapshot& scene_;
  std::vector<uint32_t> punctual_, suns_, extended_;  // emitters: without extent, directional, with extent
  std::vector<Part> parts_;
  bool others_ = false;  // some specular light has no image
  FlatMirrors out_;
};

}  // namespace

FlatMirrors find_flat_mirrors(const Snapshot& scene) { return Search(scene).find(); }

size_t FlatMirrors::bytes() const {
  size_t sum = planes.capacity() * sizeof(Plane) + images.capacity() * sizeof(Image) +
               (image_numbers.capacity() + column_of_emitter.capacity()) * sizeof(uint32_t) + tree.bytes();
  for (const auto& of_triangle : planes_of_instance) sum += of_triangle.capacity() * sizeof(uint32_t);
  return sum;
}

}  // namespace ups
