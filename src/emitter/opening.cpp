// Faces are sampled by area, balls by the cone that they are seen in, mantles by their width as seen. In coordinates
// divided by half the extents ellipses are circles and ellipsoids balls: what is seen of them stays what is seen.
#include "emitter/opening.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/warp.h"

namespace ups {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest_u = 1 - 0x1p-24;
constexpr double far_away = 100;  // in radii: beyond, faces weigh as if they were small

double at(const Vec3d& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
// The coordinates: `along` on the axis, then those of the next two axes in turn.
Vec3d by_axis(int axis, double along, double first, double second) {
  return axis == 0   ? Vec3d(along, first, second)
         : axis == 1 ? Vec3d(second, along, first)
                     : Vec3d(first, second, along);
}
Vec3d axis_normal(int axis, double sign) { return by_axis(axis, std::copysign(1.0, sign), 0, 0); }

int axis_of(const photometry::Opening& opening) {
  using photometry::OpeningShape;
  for (int k = 0; k < 3; ++k)
    if (!(opening.size_m[k] > 0)) return k;
  const bool turns = opening.shape == OpeningShape::cylinder || opening.shape == OpeningShape::disc;
  return turns ? std::clamp(opening.axis, 0, 2) : 2;
}

// Which of the weights u falls on; u becomes a number of its own again. -1: all are 0.
int choose(const std::array<double, 3>& weights, float& u) {
  const double total = weights[0] + weights[1] + weights[2];
  if (!(total > 0)) return -1;
  double rest = double(u) * total;
  int last = -1;
  for (int k = 0; k < 3; ++k) {
    if (!(weights[k] > 0)) continue;
    last = k;
    if (rest < weights[k]) break;
    rest -= weights[k];
  }
  u = float(std::clamp(rest / weights[last], 0.0, largest_u));
  return last;
}

// Of a rectangle at height h above a point, between x0, x1 and y0, y1.
double rectangle_solid_angle(double x0, double x1, double y0, double y1, double h) {
  const auto corner = [h](double x, double y) { return std::atan2(x * y, h * std::sqrt(x * x + y * y + h * h)); };
  return std::max(0.0, corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0));
}

// Where a line runs inside a ball or a disc of radius 1 or an interval: from..to. o and d in unit coordinates of the
// axes that count, the others 0.
bool inside_unit(const Vec3d& o, const Vec3d& d, double& from, double& to) {
  const double a = length2(d);
  if (!(a > 0)) return from = -infinity, to = infinity, length2(o) <= 1;
  const double middle = -dot(o, d) / a;
  const double half2 = (1 - length2(o + d * middle)) / a;  // from the nearest point: no cancellation far away
  if (!(half2 > 0)) return false;
  from = middle - std::sqrt(half2), to = middle + std::sqrt(half2);
  return true;
}

}  // namespace

// ---- the body ----

bool LuminousBody::has_area(const photometry::Opening& opening) {
  const float* m = opening.size_m;
  return opening.shape != photometry::OpeningShape::point && (m[0] > 0) + (m[1] > 0) + (m[2] > 0) >= 2;
}

LuminousBody::Kind LuminousBody::kind_of(const photometry::Opening& opening) {
  using photometry::OpeningShape;
  const float* m = opening.size_m;
  const bool flat = !(m[0] > 0 && m[1] > 0 && m[2] > 0);
  switch (opening.shape) {
    case OpeningShape::sphere:
      return flat ? Kind::ellipse : Kind::ellipsoid;
    case OpeningShape::disc:
      return flat ? Kind::ellipse : Kind::cylinder;
    case OpeningShape::cylinder:  // without length a disc, without width the rectangle that it is seen as
      return !flat ? Kind::cylinder : axis_of(opening) == opening.axis ? Kind::ellipse : Kind::rectangle;
    default:
      return flat ? Kind::rectangle : Kind::box;
  }
}

LuminousBody::LuminousBody(const photometry::Opening& opening) : kind_(kind_of(opening)), axis_(axis_of(opening)) {
  if (!has_area(opening)) fail_argument("a luminous opening with less than two extents cannot emit as an area");
  const auto half = [&](int k) { return 0.5 * double(opening.size_m[(axis_ + k) % 3]); };
  half_ = {half(1), half(2), std::max(0.0, half(3))};
  const double a = half_.x, b = half_.y, c = half_.z, faces = 8 * (a * b + b * c + c * a);
  // Ramanujan's perimeter of an ellipse, Thomsen's area of an ellipsoid.
  const double perimeter = pi_d * (3 * (a + b) - std::sqrt((3 * a + b) * (a + 3 * b)));
  const auto power = [](double x) { return std::pow(x, 1.6075); };
  switch (kind_) {
    case Kind::rectangle:
      area_ = 4 * a * b;
      break;
    case Kind::ellipse:
      area_ = pi_d * a * b;
      break;
    case Kind::box:
      area_ = faces;
      break;
    case Kind::cylinder:
      area_ = 2 * pi_d * a * b + 2 * c * perimeter;
      break;
    case Kind::ellipsoid:
      area_ = 4 * pi_d * std::pow((power(a * b) + power(b * c) + power(c * a)) / 3, 1 / 1.6075);
      break;
  }
  if (!(float(area_) > 0) || !std::isfinite(float(area_)) || !std::isfinite(float(1 / area_)))
    fail_argument("a luminous opening's area is outside the range of a float");
}

Frame LuminousBody::turned(const Frame& f) const {
  return axis_ == 0 ? Frame(f.t, f.n, f.s) : axis_ == 1 ? Frame(f.n, f.s, f.t) : f;
}

double LuminousBody::circumscribed_radius() const {
  switch (kind_) {
    case Kind::rectangle:
    case Kind::box:
      return length(half_);
    case Kind::cylinder:
      return std::hypot(std::max(half_.x, half_.y), half_.z);
    default:
      return max_abs(half_);
  }
}

double LuminousBody::projected_area(const Vec3d& w, double margin) const {
  const Vec3d half = half_ + Vec3d(margin, margin, margin);
  const double a = half.x, b = half.y, c = half.z;
  switch (kind_) {
    case Kind::rectangle:
    case Kind::ellipse:
      return area_ * std::abs(w.z);
    case Kind::box:
      return 4 * (b * c * std::abs(w.x) + c * a * std::abs(w.y) + a * b * std::abs(w.z));
    case Kind::cylinder:
      return mantle_seen(half, w) + pi_d * a * b * std::abs(w.z);
    default:
      return pi_d * length(Vec3d(b * c * w.x, c * a * w.y, a * b * w.z));
  }
}

// ---- its parts ----

double LuminousBody::face_area(int axis) const {
  const double rectangle = at(half_, (axis + 1) % 3) * at(half_, (axis + 2) % 3);
  return (kind_ == Kind::ellipse || kind_ == Kind::cylinder ? pi_d : 4) * rectangle;
}

void LuminousBody::sample_face(int axis, double sign, const Vec2& u, Point& out) const {
  const bool round = kind_ == Kind::ellipse || kind_ == Kind::cylinder;
  const Vec2 q = round ? square_to_disc(u) : Vec2{2 * u.x - 1, 2 * u.y - 1};
  out.n = axis_normal(axis, sign);
  out.p = by_axis(axis, std::copysign(at(half_, axis), sign), q.x * at(half_, (axis + 1) % 3),
                  q.y * at(half_, (axis + 2) % 3));
}

// Of a box's faces, that the reference is in front of: their solid angles.
std::array<double, 3> LuminousBody::face_weights(const Vec3d& reference) const {
  std::array<double, 3> weights;
  const bool far = length(reference) > far_away * circumscribed_radius();
  for (int k = 0; k < 3; ++k) {
    const double height = std::abs(at(reference, k)) - at(half_, k);
    const double x = at(reference, (k + 1) % 3), y = at(reference, (k + 2) % 3);
    const double hx = at(half_, (k + 1) % 3), hy = at(half_, (k + 2) % 3);
    weights[k] = !(height > 0) ? 0
                 : far         ? face_area(k) * height / length(reference)
                               : rectangle_solid_angle(-hx - x, hx - x, -hy - y, hy - y, height);
  }
  return weights;
}

double LuminousBody::box_pdf(const Vec3d& reference, const std::array<double, 3>& weights, const Vec3d& n) const {
  const int face = n.x != 0 ? 0 : n.y != 0 ? 1 : 2;
  const double total = weights[0] + weights[1] + weights[2];
  return weights[face] > 0 && at(reference, face) * at(n, face) > 0 ? weights[face] / (total * face_area(face)) : 0;
}

double LuminousBody::mantle_seen(const Vec3d& half, const Vec3d& w) {
  return 4 * half.z * std::hypot(half.y * w.x, half.x * w.y);
}

// How often a cylinder's mantle is chosen over the end that the reference faces, if it sees both: as it is seen from
// afar, where that is exact; near by either may be the larger, so neither is left out.
double LuminousBody::mantle_share(const Vec3d& reference) const {
  const bool end = std::abs(reference.z) > half_.z;
  const bool mantle = std::hypot(reference.x / half_.x, reference.y / half_.y) > 1;
  if (!end || !mantle) return mantle ? 1 : 0;
  const double sides = mantle_seen(half_, reference), ends = face_area(2) * std::abs(reference.z);
  const double radius = circumscribed_radius(), least = 0.1 / std::max(1.0, length2(reference) / (radius * radius));
  return std::clamp(sides / (sides + ends), least, 1 - least);
}

// Area of the mantle per length and angle, at (cos, sin) of its unit circle.
double LuminousBody::mantle_stretch(double c, double s) const { return std::hypot(half_.x * s, half_.y * c); }

// `sine`: of the angle in the unit circle from the direction to `towards`.
void LuminousBody::place_on_mantle(const Vec3d& towards, double sine, double v, Point& out) const {
  const double x = towards.x / half_.x, y = towards.y / half_.y, r = std::hypot(x, y);
  const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
  const double c = (x * cosine - y * sine) / r, s = (y * cosine + x * sine) / r;
  out.p = {half_.x * c, half_.y * s, half_.z * (2 * v - 1)};
  out.n = Vec3d(half_.y * c, half_.x * s, 0) / mantle_stretch(c, s);
}

// Where the reference sees the mantle, the sine about it is uniform: what is seen from afar, but of this part alone.
double LuminousBody::mantle_pdf(const Vec3d& reference, const Vec3d& p) const {
  const double x = reference.x / half_.x, y = reference.y / half_.y, r = std::hypot(x, y);
  const double px = p.x / half_.x, py = p.y / half_.y, radius = std::hypot(px, py);
  const double cosine = (px * x + py * y) / (radius * r), largest = std::sqrt((r - 1) * (r + 1)) / r;
  if (!(largest > 0) || !(cosine > 0)) return 0;
  return cosine / (2 * largest * 2 * half_.z * mantle_stretch(px / radius, py / radius));
}

double LuminousBody::cylinder_pdf(const Vec3d& reference, double share, const Vec3d& p, const Vec3d& n) const {
  if (n.z == 0) return share * mantle_pdf(reference, p);
  return reference.z * n.z > half_.z ? (1 - share) / face_area(2) : 0;
}

void LuminousBody::place_on_ball(const Vec3d& q, Point& out) const {
  out.p = {half_.x * q.x, half_.y * q.y, half_.z * q.z};
  out.n = normalize(Vec3d(q.x / half_.x, q.y / half_.y, q.z / half_.z));
}

// In unit coordinates, uniform in the cone that a ball is seen in (Pharr, Jakob, Humphreys 2016, 14.2.2).
bool LuminousBody::sample_cap(const Vec3d& reference, const Vec2& u, Point& out) const {
  const Vec3d r = to_unit(reference);
  const double d2 = length2(r);
  if (!(d2 > 1)) return false;
  const double d = std::sqrt(d2), cone = 1 / (d2 * (1 + std::sqrt((d2 - 1) / d2)));  // 1 - cosine of its half angle
  const double versine = double(u.x) * cone, sine2 = versine * (2 - versine);
  const double c = d * sine2 + (1 - versine) * std::sqrt(std::max(0.0, 1 - sine2 * d2));
  const double s = std::sqrt(std::max(0.0, (1 - c) * (1 + c))), phi = 2 * pi_d * double(u.y);
  const Vec3d n = r / d;
  const Frame about{Vec3(n)};
  const Vec3d x = normalize(Vec3d(about.s) - n * dot(Vec3d(about.s), n)), y = cross(n, x);
  place_on_ball(normalize(n * c + x * (s * std::cos(phi)) + y * (s * std::sin(phi))), out);
  return true;
}

double LuminousBody::cap_pdf(const Vec3d& reference, const Vec3d& p) const {
  const Vec3d r = to_unit(reference), q = normalize(to_unit(p)), to_r = r - q;
  const double d2 = length2(r), distance2 = length2(to_r), cosine = dot(q, to_r) / std::sqrt(distance2);
  if (!(d2 > 1) || !(cosine > 0)) return 0;
  const double cone = 1 / (d2 * (1 + std::sqrt((d2 - 1) / d2)));
  const double stretch = half_.x * half_.y * half_.z * length(to_unit(q));  // area over the ball's
  return cosine / (distance2 * 2 * pi_d * cone * stretch);
}

// ---- sampling ----

bool LuminousBody::sample_seen_along(const Vec3d& w, Vec2 u, Point& out) const {
  const double total = projected_area(w);
  if (!(total > 0)) return false;
  const double ends = face_area(2) * std::abs(w.z);
  switch (kind_) {
    case Kind::rectangle:
    case Kind::ellipse:
      sample_face(2, w.z, u, out);
      break;
    case Kind::box: {
      const std::array<double, 3> weights = {face_area(0) * std::abs(w.x), face_area(1) * std::abs(w.y), ends};
      const int face = choose(weights, u.x);
      if (face < 0) return false;
      sample_face(face, at(w, face), u, out);
      break;
    }
    case Kind::cylinder:
      if (choose({ends, total - ends, 0}, u.x) == 0)
        sample_face(2, w.z, u, out);
      else
        place_on_mantle(w, 2 * double(u.x) - 1, u.y, out);
      break;
    case Kind::ellipsoid: {  // parallel projections stay uniform in unit coordinates
      const Vec3 local = square_to_cosine_hemisphere(u);
      const Frame about{Vec3(normalize(to_unit(w)))};
      place_on_ball(normalize(Vec3d(about.to_world(local))), out);
      break;
    }
  }
  out.pdf_a = dot(out.n, w) / total;
  return out.pdf_a > 0;
}

bool LuminousBody::sample_seen_from(const Vec3d& reference, Vec2 u, Point& out) const {
  switch (kind_) {
    case Kind::rectangle:
    case Kind::ellipse:
      sample_face(2, reference.z, u, out), out.pdf_a = 1 / area_;
      break;
    case Kind::box: {
      const std::array<double, 3> weights = face_weights(reference);
      const int face = choose(weights, u.x);
      if (face < 0) return false;
      sample_face(face, at(reference, face), u, out);
      out.pdf_a = box_pdf(reference, weights, out.n);
      break;
    }
    case Kind::cylinder: {
      const double share = mantle_share(reference), r = std::hypot(reference.x / half_.x, reference.y / half_.y);
      if (!(share > 0) && !(std::abs(reference.z) > half_.z)) return false;
      if (choose({share, 1 - share, 0}, u.x) == 0)
        place_on_mantle(reference, (2 * double(u.x) - 1) * std::sqrt((r - 1) * (r + 1)) / r, u.y, out);
      else
        sample_face(2, reference.z, u, out);
      out.pdf_a = cylinder_pdf(reference, share, out.p, out.n);
      break;
    }
    case Kind::ellipsoid:
      if (!sample_cap(reference, u, out)) return false;
      out.pdf_a = cap_pdf(reference, out.p);
      break;
  }
  return out.pdf_a > 0;
}

double LuminousBody::pdf_seen_from(const Vec3d& reference, const Vec3d& p, const Vec3d& n) const {
  switch (kind_) {
    case Kind::box:
      return box_pdf(reference, face_weights(reference), n);
    case Kind::cylinder:
      return cylinder_pdf(reference, mantle_share(reference), p, n);
    case Kind::ellipsoid:
      return cap_pdf(reference, p);
    default:
      return 1 / area_;
  }
}

// ---- hits ----

bool LuminousBody::normal_at(const Vec3d& p, const Vec3d& w, Vec3d& n) const {
  if (kind_ == Kind::ellipsoid) {
    n = normalize(Vec3d(p.x / (half_.x * half_.x), p.y / (half_.y * half_.y), p.z / (half_.z * half_.z)));
    return dot(n, w) > 0;
  }
  // The nearest of the parts that face w.
  double nearest = infinity;
  for (int k = kind_ == Kind::box ? 0 : 2; k < 3; ++k) {
    const double off = std::abs(std::copysign(at(half_, k), at(w, k)) - at(p, k));
    if (at(w, k) != 0 && off < nearest) nearest = off, n = axis_normal(k, at(w, k));
  }
  if (kind_ == Kind::cylinder) {
    const double x = p.x / half_.x, y = p.y / half_.y, r = std::hypot(x, y);
    if (!(r > 0)) return nearest < infinity;
    const double off = std::abs(r - 1) * std::min(half_.x, half_.y);
    const Vec3d mantle = Vec3d(half_.y * x, half_.x * y, 0) / (r * mantle_stretch(x / r, y / r));
    if (dot(mantle, w) > 0 && off < nearest) nearest = off, n = mantle;
  }
  return nearest < infinity;
}

bool LuminousBody::enter(const Vec3d& o, const Vec3d& d, double margin, double& t, Vec3d& n) const {
  if (is_flat()) {
    if (d.z == 0) return false;
    t = (margin - o.z) / d.z;
    if (!(t > 0)) return false;
    const double x = (o.x + d.x * t) / half_.x, y = (o.y + d.y * t) / half_.y;
    n = axis_normal(2, -d.z);
    return kind_ == Kind::ellipse ? x * x + y * y <= 1 : std::max(std::abs(x), std::abs(y)) <= 1;
  }
  const Vec3d half = half_ + Vec3d(margin, margin, margin);
  const Vec3d q(o.x / half.x, o.y / half.y, o.z / half.z), e(d.x / half.x, d.y / half.y, d.z / half.z);
  double first = -infinity, last = infinity, from, to;
  // Cuts the line to a part of the axes; `face`: the normal where that part is the last to be entered.
  const auto cut = [&](const Vec3d& mask, int face) {
    const auto masked = [&](const Vec3d& v) { return Vec3d(v.x * mask.x, v.y * mask.y, v.z * mask.z); };
    if (!inside_unit(masked(q), masked(e), from, to)) return false;
    last = std::min(last, to);
    if (from <= first) return true;
    first = from;
    const Vec3d s = masked(q + e * from);
    n = face < 3 ? axis_normal(face, -at(d, face)) : normalize(Vec3d(s.x / half.x, s.y / half.y, s.z / half.z));
    return true;
  };
  constexpr int curved = 3;
  bool meets = true;
  if (kind_ == Kind::box)
    meets = cut({1, 0, 0}, 0) && cut({0, 1, 0}, 1) && cut({0, 0, 1}, 2);
  else if (kind_ == Kind::cylinder)
    meets = cut({1, 1, 0}, curved) && cut({0, 0, 1}, 2);
  else
    meets = cut({1, 1, 1}, curved);
  t = first;
  return meets && first < last && first > 0;
}

}  // namespace ups
