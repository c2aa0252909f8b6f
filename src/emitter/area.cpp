// Lambertian area emitter: position uniform by area, direction by cosine. Next-event estimation uses the same
// positions.
#include "emitter/area.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "base/warp.h"
#include "emitter/lobe.h"
#include "geometry/box.h"

namespace ups {
namespace {

Vec3d doubled_area(const EmitterTriangle& t) { return cross(Vec3d(t.p1) - Vec3d(t.p0), Vec3d(t.p2) - Vec3d(t.p0)); }

// The bounding box's centre, and the sphere about it that holds all corners.
void bound(const std::vector<EmitterTriangle>& triangles, Vec3& center, Vec3& half, float& radius) {
  if (triangles.empty()) return;
  Vec3 low = triangles[0].p0, high = low;
  const auto each = [&](const auto& visit) {
    for (const EmitterTriangle& t : triangles) visit(t.p0), visit(t.p1), visit(t.p2);
  };
  each([&](const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  });
  center = low * 0.5f + high * 0.5f;
  half = high - center;
  each([&](const Vec3& p) { radius = std::max(radius, length(p - center)); });
}

}  // namespace

AreaEmitter::AreaEmitter(std::vector<EmitterTriangle> triangles, const Rgb& radiance, bool both_sides,
                         uint32_t instance)
    : triangles_(std::move(triangles)), radiance_(radiance), both_sides_(both_sides), instance_(instance) {
  std::vector<double> areas;
  for (const EmitterTriangle& t : triangles_) {
    const Vec3d n = doubled_area(t);
    const double size = length(n);
    areas.push_back(0.5 * size);
    normals_.push_back(size > 0 ? Vec3(n / size) : Vec3());
  }
  by_area_ = DiscreteDistribution(areas);
  if (area() > 0) pdf_a_ = float(1 / area());
  bound(triangles_, center_, half_, radius_);
}

float AreaEmitter::reach(const Vec3& n) const {
  float most = 0;
  for (const EmitterTriangle& t : triangles_)
    for (const Vec3* p : {&t.p0, &t.p1, &t.p2}) most = std::max(most, std::abs(dot(n, *p - center_)));
  return most + 0x1p-20f * max_abs(center_);
}

// A plane is told by its cosine; what is bent by its areas, gathered into as many directions as matter.
Outline AreaEmitter::outline() const {
  Outline out;
  out.center = center_;
  const float rounding = 0x1p-20f * max_abs(center_);
  out.half = half_ + Vec3(rounding, rounding, rounding);
  out.intensity = luminance(radiance_);
  std::map<int, Vec3d> areas;
  const auto add = [&](const Vec3d& a) { areas[DirectionMap<8>::texel(Vec3(a))] += a; };
  Vec3d sum;
  for (size_t i = 0; i < triangles_.size(); ++i) {
    const Vec3d a = Vec3d(normals_[i]) * (double(by_area_.probability(i)) * area());
    sum += a;
    add(a);
    if (both_sides_) add(-a);
  }
  if (length(sum) > (1 - 1e-6) * area()) {
    out.shape = both_sides_ ? Outline::Shape::two_cosines : Outline::Shape::cosine;
    out.frame = Frame(Vec3(normalize(sum)));
    out.intensity *= float(area());
    return out;
  }
  out.shape = Outline::Shape::facets;
  for (const auto& [texel, a] : areas) out.areas.push_back(Vec3(a));
  return out;
}

double AreaEmitter::flux_lm() const { return luminance(flux_rgb()); }

Rgb AreaEmitter::flux_rgb() const { return radiance_ * float(double(pi) * area() * (both_sides_ ? 2 : 1)); }

float AreaEmitter::direction_pdf(float cos_front) const {
  return both_sides_ ? 0.5f * cosine_hemisphere_pdf(std::abs(cos_front)) : cosine_hemisphere_pdf(cos_front);
}

bool AreaEmitter::sample_position(const Vec2& u, Point& out) const {
  if (!(pdf_a_ > 0)) return false;
  const DiscreteDistribution::Sample chosen = by_area_.sample(u.x);
  const EmitterTriangle& t = triangles_[chosen.index];
  const Vec2 b = square_to_triangle({chosen.u, u.y});
  out.p = t.p0 * (1 - b.x - b.y) + t.p1 * b.x + t.p2 * b.y;
  out.n = normals_[chosen.index];
  out.primitive = uint32_t(chosen.index);
  // Rounding of the corners' transform, of the triangle and of p.
  const float extent =
      std::max({max_abs(t.p0), max_abs(t.p1), max_abs(t.p2)}) + std::max(max_abs(t.p1 - t.p0), max_abs(t.p2 - t.p0));
  out.error = std::max(64 * 0x1p-24f * extent, least_error_);
  return true;
}

bool AreaEmitter::sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const {
  Point point;
  if (!sample_position(u_position, point)) return false;
  Vec2 u = u_direction;
  bool back = false;
  if (both_sides_) {
    back = u.x >= 0.5f;
    u.x = 2 * u.x - (back ? 1 : 0);
  }
  const Vec3 local = square_to_cosine_hemisphere(u);
  if (!(local.z > 0)) return false;
  out.p = point.p;
  out.n = back ? -point.n : point.n;
  out.direction = normalize(Frame(out.n).to_world(local));
  out.flux = flux_rgb();
  out.pdf_position_a = pdf_a_;
  out.pdf_direction_w = direction_pdf(back ? -local.z : local.z);
  out.cos_0 = local.z;
  out.error = point.error;
  out.instance = instance_;
  out.primitive = point.primitive;
  return true;
}

bool AreaEmitter::sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const {
  Point point;
  if (!sample_position(u, point)) return false;
  const Vec3 to_p = point.p - reference;
  const float distance2 = length2(to_p);
  if (!(distance2 > 0)) return false;
  const float distance = std::sqrt(distance2);
  const Vec3 wi = to_p / distance;
  const float cos_front = -dot(wi, point.n);
  if (cos_front == 0 || (cos_front < 0 && !both_sides_)) return false;
  out.p = point.p;
  out.n = cos_front > 0 ? point.n : -point.n;
  out.wi = wi;
  out.distance = distance;
  out.cos_0 = std::abs(cos_front);
  out.weight = radiance_ * (out.cos_0 / (distance2 * pdf_a_));
  out.pdf_nee_a = pdf_a_;
  out.pdf_position_a = pdf_a_;
  out.pdf_direction_w = direction_pdf(cos_front);
  out.error = point.error;
  out.primitive = point.primitive;
  return true;
}

namespace {

// Things that are joined step by step, each set known by its first one.
class JoinedSets {
 public:
  explicit JoinedSets(size_t count) : first_(count) { std::iota(first_.begin(), first_.end(), 0u); }
  uint32_t of(uint32_t i) {
    while (first_[i] != i) i = first_[i] = first_[first_[i]];
    return i;
  }
  void join(uint32_t i, uint32_t j) {
    const uint32_t a = of(i), b = of(j);
    first_[std::max(a, b)] = std::min(a, b);
  }
  std::vector<uint32_t> firsts() {
    std::vector<uint32_t> out;
    for (uint32_t i = 0; i < first_.size(); ++i)
      if (of(i) == i) out.push_back(i);
    return out;
  }

 private:
  std::vector<uint32_t> first_;
};

void join_at_corners(const std::vector<EmitterTriangle>& triangles, JoinedSets& sets) {
  std::vector<std::tuple<float, float, float, uint32_t>> corners;
  corners.reserve(3 * triangles.size());
  for (uint32_t i = 0; i < triangles.size(); ++i)
    for (const Vec3* p : {&triangles[i].p0, &triangles[i].p1, &triangles[i].p2})
      corners.emplace_back(p->x, p->y, p->z, i);
  std::sort(corners.begin(), corners.end());
  for (size_t k = 1; k < corners.size(); ++k) {
    const auto& [x, y, z, i] = corners[k];
    const auto& [x0, y0, z0, before] = corners[k - 1];
    if (x == x0 && y == y0 && z == z0) sets.join(i, before);
  }
}

void join_neighbours(const std::vector<EmitterTriangle>& triangles, const std::vector<uint32_t>& firsts,
                     JoinedSets& sets) {
  constexpr double least_gap_m = 0.1, least_gap = 0.25;  // of the smaller one's size: as between tiles in their frames
  std::vector<Box> boxes(firsts.size());
  for (uint32_t i = 0; i < triangles.size(); ++i) {
    const auto at = std::lower_bound(firsts.begin(), firsts.end(), sets.of(i)) - firsts.begin();
    for (const Vec3* p : {&triangles[i].p0, &triangles[i].p1, &triangles[i].p2}) boxes[size_t(at)].grow(Vec3d(*p));
  }
  const auto size = [](const Box& b) { return length(b.upper - b.lower); };
  const auto gap = [](const Box& a, const Box& b) {
    const auto along = [](double a0, double a1, double b0, double b1) { return std::max({0.0, a0 - b1, b0 - a1}); };
    return length(Vec3d(along(a.lower.x, a.upper.x, b.lower.x, b.upper.x),
                        along(a.lower.y, a.upper.y, b.lower.y, b.upper.y),
                        along(a.lower.z, a.upper.z, b.lower.z, b.upper.z)));
  };
  for (size_t i = 0; i < boxes.size(); ++i)
    for (size_t k = i + 1; k < boxes.size(); ++k)
      if (gap(boxes[i], boxes[k]) <= std::max(least_gap_m, least_gap * std::min(size(boxes[i]), size(boxes[k]))))
        sets.join(firsts[i], firsts[k]);
}

}  // namespace

std::vector<AreaEmitter> AreaEmitter::separate_parts(size_t most) const {
  JoinedSets sets(triangles_.size());
  join_at_corners(triangles_, sets);
  std::vector<uint32_t> firsts = sets.firsts();
  if (firsts.size() < 2 || firsts.size() > most) return {};
  join_neighbours(triangles_, firsts, sets);
  firsts = sets.firsts();
  if (firsts.size() < 2) return {};
  std::map<uint32_t, std::vector<EmitterTriangle>> parts;
  for (uint32_t i = 0; i < triangles_.size(); ++i) parts[sets.of(i)].push_back(triangles_[i]);
  std::vector<AreaEmitter> out;
  for (auto& [_, triangles] : parts) {
    out.emplace_back(std::move(triangles), radiance_, both_sides_, instance_);
    out.back().set_least_error(least_error_);
  }
  return out;
}

namespace {

// Of a triangle, counter-clockwise from where it is positive: van Oosterom and Strackee 1983.
double solid_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double la = length(a), lb = length(b), lc = length(c);
  const double below = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
  return -2 * std::atan2(dot(a, cross(b, c)), below);
}

struct Weighed {
  double solid_angle = 0, sum = 0, area = 0;
};
// A triangle about the eye in pieces: halves across its longest side until that is small beside its distance.
void weigh_pieces(const Vec3d (&t)[3], bool both_sides, int depth, const std::function<double(const Vec3&)>& weight,
                  Weighed& out) {
  constexpr double small = 0.25;
  constexpr int deepest = 24;  // of what the eye all but touches
  double w = solid_angle(t[0], t[1], t[2]);
  if (both_sides) w = std::abs(w);
  if (!(w > 0)) return;
  int from = 0;
  double side2 = 0;
  for (int i = 0; i < 3; ++i)
    if (const double l = length2(t[(i + 1) % 3] - t[i]); l > side2) side2 = l, from = i;
  const Vec3d center = (t[0] + t[1] + t[2]) * (1.0 / 3);
  if (depth == deepest || side2 <= small * small * length2(center)) {
    if (!(length2(center) > 0)) return;
    out.solid_angle += w;
    out.sum += w * weight(Vec3(normalize(center)));
    out.area += w * length2(center);
    return;
  }
  const Vec3d &a = t[from], &b = t[(from + 1) % 3], &c = t[(from + 2) % 3], middle = (a + b) * 0.5;
  weigh_pieces({a, middle, c}, both_sides, depth + 1, weight, out);
  weigh_pieces({middle, b, c}, both_sides, depth + 1, weight, out);
}

}  // namespace

AreaEmitter::Stretch AreaEmitter::stretch_over(const Vec3& eye,
                                               const std::function<double(const Vec3&)>& weight) const {
  Weighed all;
  for (const EmitterTriangle& t : triangles_)
    weigh_pieces({Vec3d(t.p0) - Vec3d(eye), Vec3d(t.p1) - Vec3d(eye), Vec3d(t.p2) - Vec3d(eye)}, both_sides_, 0, weight,
                 all);
  return {all.solid_angle > 0 ? all.sum / all.solid_angle : 0, all.area};
}

bool AreaEmitter::seen_from(const Vec3& eye, Sight& out) const {
  Vec3d center;
  double sum = 0;
  for (const EmitterTriangle& t : triangles_) {
    const Vec3d a = Vec3d(t.p0) - Vec3d(eye), b = Vec3d(t.p1) - Vec3d(eye), c = Vec3d(t.p2) - Vec3d(eye);
    double w = solid_angle(a, b, c);
    if (both_sides_) w = std::abs(w);
    if (!(w > 0)) continue;
    sum += w;
    center += (a + b + c) * (w / 3);
  }
  if (!(sum > 0)) return false;
  const double distance = length(center) / sum;
  if (!(distance > 0)) return false;
  out = {Vec3(normalize(center)), distance, double(luminance(radiance_)) * sum * distance * distance, sum};
  return true;
}

bool AreaEmitter::eval_hit(const Vec3&, const Vec3&, uint32_t primitive, const Vec3& wo, EmitterHit& out) const {
  if (primitive >= normals_.size()) return false;
  const float cos_front = dot(wo, normals_[primitive]);
  if (cos_front == 0 || (cos_front < 0 && !both_sides_)) return false;
  out.radiance = radiance_;
  out.pdf_nee_a = pdf_a_;
  out.pdf_position_a = pdf_a_;
  out.pdf_direction_w = direction_pdf(cos_front);
  return true;
}

bool AreaEmitter::emission_square(const Vec3&, uint32_t primitive, const Vec3& direction, Vec2& u) const {
  if (primitive >= normals_.size()) return false;
  const Vec3& n = normals_[primitive];
  const float cos_front = dot(direction, n);
  if (cos_front == 0 || (cos_front < 0 && !both_sides_)) return false;
  const bool back = cos_front < 0;
  const Vec3 local = Frame(back ? -n : n).to_local(direction);
  u = disc_to_square({local.x, local.y});
  if (both_sides_) u.x = 0.5f * (u.x + (back ? 1 : 0));
  return true;
}

}  // namespace ups
