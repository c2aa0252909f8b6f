// See builder.h: meters at given places, and those on surfaces, a triangle or a texel each.
#include <algorithm>
#include <cmath>

#include "scene/builder.h"
#include "scene/check.h"
#include "scene/glass_edges.h"
#include "scene/lightmap.h"
#include "scene/footing.h"

namespace ups {

MeterSet Builder::make_meters(const MetersDescription& in) const {
  MeterSet set;
  set.kind = in.kind;
  set.cell_width = in.cell_width, set.cell_height = in.cell_height, set.disc_radius = 0.5f * in.footprint;
  set.positions = in.positions;
  set.meters.resize(in.positions->size());
  parallel_for(threads_, set.meters.size(), [&](size_t i) {
    Meter& meter = set.meters[i];
    const Vec3d n = normalize(Vec3d(in.normals[i]));
    meter.p = to_scene((*in.positions)[i]);
    meter.frame = Frame(Vec3(n));
    if (!in.tangents.empty()) {
      const Vec3d t(in.tangents[i]), s = normalize(t - n * dot(t, n));
      meter.frame = {Vec3(s), Vec3(cross(n, s)), Vec3(n)};
    }
    if (!set.is_cell()) meter.p = off_walls(*out_, meter.p, meter.frame);
    const bool disc = set.disc_radius > 0;
    const Vec3 half_a = meter.frame.s * (disc ? set.disc_radius : 0.5f * set.cell_width),
               half_b = meter.frame.t * (disc ? set.disc_radius : 0.5f * set.cell_height);
    meter.error = set.is_cell() ? error_at(*out_, meter.p, meter.frame.n, half_a, half_b)
                                : error_at(*out_, meter.p, meter.frame.n);
    if (in.kind != UPS_METER_PLANAR) {
      meter.p = meter.p + meter.frame.n * (2 * meter.error);  // it sees both sides from there
      meter.error = 0;
    }
    meter.moved = length(meter.p - to_scene((*in.positions)[i]));
  });
  if (in.kind == UPS_METER_VECTOR) {
    const size_t points = set.meters.size();
    set.meters.reserve(vector_sides * points);
    for (size_t i = 0; i < (vector_sides - 1) * points; ++i) set.meters.push_back(set.meters[i]);
  }
  return set;
}

void Builder::note_glass_edges(uint32_t id, const MeterSet& meters) {
  const GlassEdges found = find_glass_edges(*out_, meters, threads_);
  const auto some = [&](size_t count) {
    return "meters " + std::to_string(id) + ": " + std::to_string(count) + " of " + std::to_string(meters.count());
  };
  std::vector<std::string>& warnings = out_->sensor_warnings[id];
  if (found.beside > 0)
    warnings.push_back(some(found.beside) + " lie within 1 cm of an edge of glass that is less than 5 cm above them: "
                       "light has an edge there, and readings may be off by 5 %, whatever their bounds");
  if (found.touching > 0)
    warnings.push_back(some(found.touching) + " touch a solid of glass: whether there is air between is a matter of "
                       "rounding, and readings may be off by 4 %; a gap of 0.1 mm would decide it");
  if (warnings.empty()) out_->sensor_warnings.erase(id);
}

namespace {

constexpr uint64_t max_surface_triangles = 16'777'216;

using Corners = std::array<Vec3d, 3>;

Vec3d area_normal(const Corners& c) { return cross(c[1] - c[0], c[2] - c[0]) * 0.5; }

// A surface's triangles, counted through its instances, as their meters see them: counter-clockwise from their side.
class Surface {
 public:
  Surface(const Snapshot& scene, const SurfaceMetersDescription& in)
      : scene_(scene), placed_(scene.instances), back_(in.back) {
    uint64_t triangles = 0;
    for (const ups_instance_id id : in.instances) {
      const uint32_t number = number_of(id.v);
      const auto at = std::lower_bound(scene.instance_ids.begin(), scene.instance_ids.end(), number);
      if (at == scene.instance_ids.end() || *at != number)
        fail_argument("measures instance " + std::to_string(number) +
                      ", which was removed; remove the sensor too, or add it anew with an instance of the scene");
      instances_.push_back(uint32_t(at - scene.instance_ids.begin()));
      const Mesh& shown = mesh(instances_.size() - 1);  // another, perhaps, than when the sensor was added
      check::require(in.width == 0 || !shown.uvs.empty(), "measures instance " + std::to_string(number) +
                                                              ", whose mesh has no uvs any more; a lightmap needs them");
      check::require(!shown.revolution, "measures instance " + std::to_string(number) +
                                            ", which has become a curved part of a fixture");
      triangles += shown.triangle_count();
      const uint64_t most = in.width > 0 ? UINT32_MAX : max_surface_triangles;
      check::require(triangles <= most, "measures more than " + std::to_string(most) + " triangles");
      ends_.push_back(uint32_t(triangles));
    }
  }
  uint32_t count() const { return ends_.empty() ? 0 : ends_.back(); }

  Corners corners(uint32_t triangle) const {
    const auto [i, t] = place(triangle);
    const Affine& to_scene = placed_[instances_[i]].to_scene;
    Corners c;
    for (size_t k = 0; k < 3; ++k) c[k] = to_scene.point(Vec3d(mesh(i).positions[mesh(i).indices[3 * size_t(t) + k]]));
    if (is_turned(i)) std::swap(c[1], c[2]);
    return c;
  }
  std::array<Vec2d, 3> uv(uint32_t triangle) const {  // of its corners
    const auto [i, t] = place(triangle);
    std::array<Vec2d, 3> out;
    for (size_t k = 0; k < 3; ++k) {
      const Vec2& uv = mesh(i).uvs[mesh(i).indices[3 * size_t(t) + k]];
      out[k] = {double(uv.x), double(uv.y)};
    }
    if (is_turned(i)) std::swap(out[1], out[2]);
    return out;
  }
  // As far as the surface may be from where it should be, and another that lies on it.
  float error(uint32_t triangle, const Corners& c) const {
    const auto [i, t] = place(triangle);
    const Vec3 n(normalize(area_normal(c)));
    float error = error_at(scene_, Vec3((c[0] + c[1] + c[2]) / 3.0), n);
    for (const Vec2& uv : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}) {
      const SurfacePoint s = scene_.raytracer->surface_at(instances_[i], t, uv.x, uv.y);
      error = std::max(error, s.error + free_error(s.p));
    }
    return error;
  }

 private:
  const Mesh& mesh(size_t i) const { return *scene_.meshes[placed_[instances_[i]].mesh]; }
  bool is_turned(size_t i) const { return back_ != (placed_[instances_[i]].to_scene.determinant() < 0); }
  std::pair<size_t, uint32_t> place(uint32_t triangle) const {
    const size_t i = size_t(std::upper_bound(ends_.begin(), ends_.end(), triangle) - ends_.begin());
    return {i, triangle - (i ? ends_[i - 1] : 0)};
  }

  const Snapshot& scene_;
  const std::vector<Raytracer::Instance>& placed_;
  bool back_;
  std::vector<uint32_t> instances_, ends_;  // indices; by instance, how many triangles it and those before it have
};

// Laid along its longest side, whose direction is known best. False without area, by the same rule as doubts.h.
bool make_triangle(const Corners& corners, float error, MeterTriangle& out) {
  size_t first = 0;
  double longest = 0;
  for (size_t k = 0; k < 3; ++k)
    if (const double side = length(corners[(k + 1) % 3] - corners[k]); side > longest) longest = side, first = k;
  const Vec3d n = area_normal(corners), origin = corners[first], third = corners[(first + 2) % 3] - origin;
  const double area = length(n);
  if (!(2 * area > 0x1p-24 * longest * longest && float(2 * area / longest) > 0 && std::isfinite(float(area))))
    return false;
  const Vec3d s = (corners[(first + 1) % 3] - origin) / longest, unit = n / area;
  out.at = {Vec3(origin), {Vec3(s), Vec3(cross(unit, s)), Vec3(unit)}, error};
  out.second = float(longest);
  out.third = {float(dot(third, s)), float(2 * area / longest)};
  return true;
}

// Meters from their triangles, which come in the order of the meters' numbers.
class SurfaceMeters {
 public:
  explicit SurfaceMeters(uint32_t declared) { set_.declared = declared; }
  void add(uint32_t number, uint32_t triangle, const Corners& corners, float error) {
    MeterTriangle part;
    if (!make_triangle(corners, error, part)) return;
    if (set_.numbers.empty() || set_.numbers.back() != number) begin(number);
    const Vec3d n = area_normal(corners);
    const double area = length(n);
    area_ += area, normal_ += n, center_ += (corners[0] + corners[1] + corners[2]) * (area / 3);
    of_triangle_ = triangle == triangle_ ? of_triangle_ + area : area;
    triangle_ = triangle;
    if (of_triangle_ > most_) most_ = of_triangle_, set_.surface_triangle.back() = triangle;
    set_.triangles.push_back(part);
    up_to_.push_back(area_);
  }
  MeterSet take(bool lightmap) {
    end();
    set_.first_triangle.push_back(uint32_t(set_.triangles.size()));
    if (!lightmap) set_.surface_triangle.clear();
    if (set_.numbers.size() == set_.declared) set_.numbers.clear();
    return std::move(set_);
  }
  double area() const { return total_ + area_; }

 private:
  void begin(uint32_t number) {
    end();
    set_.numbers.push_back(number);
    set_.first_triangle.push_back(uint32_t(set_.triangles.size()));
    set_.surface_triangle.push_back(0);
    total_ += area_;
    area_ = of_triangle_ = most_ = 0, triangle_ = UINT32_MAX;
    normal_ = center_ = {};
    up_to_.clear();
  }
  void end() {
    if (set_.numbers.empty()) return;
    const size_t first = set_.first_triangle.back();
    for (size_t k = 0; k < up_to_.size(); ++k) set_.triangles[first + k].up_to = float(up_to_[k] / area_);
    const bool has_normal = length(normal_) > 1e-6 * area_;  // sides that face each other may cancel
    const Meter& at = set_.triangles[first].at;
    set_.meters.push_back({Vec3(center_ / area_), has_normal ? Frame(Vec3(normalize(normal_))) : at.frame, at.error});
    set_.areas.push_back(area_);
  }

  MeterSet set_;
  // Of the meter that is being made.
  double area_ = 0, of_triangle_ = 0, most_ = 0, total_ = 0;
  uint32_t triangle_ = UINT32_MAX;
  Vec3d normal_, center_;
  std::vector<double> up_to_;
};

std::string texel_text(uint32_t texel, uint32_t width) {
  return "column " + std::to_string(texel % width) + ", row " + std::to_string(texel / width);
}

}  // namespace

MeterSet Builder::make_surface_meters(uint32_t id, const SurfaceMetersDescription& in) {
  const Surface surface(*out_, in);
  std::vector<float> errors(surface.count());
  parallel_for(threads_, errors.size(), [&](size_t t) {
    const Corners c = surface.corners(uint32_t(t));
    if (length(area_normal(c)) > 0) errors[t] = surface.error(uint32_t(t), c);
  });
  if (in.width == 0) {
    SurfaceMeters meters(surface.count());
    for (uint32_t t = 0; t < surface.count(); ++t) meters.add(t, t, surface.corners(t), errors[t]);
    MeterSet set = meters.take(false);
    check::require(!set.meters.empty(), "none of the " + std::to_string(surface.count()) +
                                            " triangles has an area; meters want a surface that can be lit");
    return set;
  }
  LightmapCut cut(in.width, in.height);
  double whole = 0;
  in_context("lightmap " + std::to_string(id), [&] {
    for (uint32_t t = 0; t < surface.count(); ++t) {
      monitor_.check();
      whole += length(area_normal(surface.corners(t)));
      cut.add(t, surface.uv(t));
    }
  });
  SurfaceMeters meters(in.width * in.height);
  for (const TexelPart& part : cut.take()) {
    const Corners whole_triangle = surface.corners(part.triangle);
    Corners c;
    for (size_t k = 0; k < 3; ++k)
      c[k] = whole_triangle[0] * part.weights[k][0] + whole_triangle[1] * part.weights[k][1] +
             whole_triangle[2] * part.weights[k][2];
    if (dot(area_normal(c), area_normal(whole_triangle)) < 0) std::swap(c[1], c[2]);  // mirrored in UV
    meters.add(part.texel, part.triangle, c, errors[part.triangle]);
  }
  const double missing = whole - meters.area();
  MeterSet set = meters.take(true);
  check::require(!set.meters.empty(), "no texel of the lightmap has anything in it; the UVs must lie in the unit square");
  const std::string name = "lightmap " + std::to_string(id) + ": ";
  std::vector<std::string>& warnings = out_->sensor_warnings[id];
  if (missing > 1e-5 * whole)
    warnings.push_back(name + check::text(missing) + " of " + check::text(whole) + " m^2 of the surface is not measured: " +
         (cut.flat() ? std::to_string(cut.flat()) + " of its triangles have no area in UV, or it" : "it") +
         " lies outside the unit square of the UVs");
  if (const LightmapCut::Overlaps& o = cut.overlaps(); o.texels > 0)
    warnings.push_back(name + "different triangles overlap in " + std::to_string(o.texels) + " of its texels, such as " +
         texel_text(o.texel, in.width) + " (triangles " + std::to_string(o.first) + " and " + std::to_string(o.second) +
         "): each such reading is the mean over all of them; UVs of their own would keep them apart");
  return set;
}

}  // namespace ups
