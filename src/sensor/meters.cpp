// See meters.h.
#include "sensor/meters.h"

#include <algorithm>
#include <cmath>

#include "base/warp.h"

namespace ups {

bool MeterTriangle::covers(float x, float y) const {
  if (y < 0 || y > third.y) return false;
  const float v = y / third.y, left = v * third.x;
  return x >= left && x <= left + (1 - v) * second;
}

double MeterSet::area(size_t m) const {
  if (on_surface()) return areas[m];
  if (disc_radius > 0) return 3.14159265358979323846 * disc_radius * disc_radius;
  return double(cell_width) * double(cell_height);
}

bool MeterSet::covers(size_t m, size_t k, float x, float y) const {
  if (on_surface()) return triangles[first_triangle[m] + k].covers(x, y);
  if (disc_radius > 0) return x * x + y * y <= disc_radius * disc_radius;
  return std::abs(x) * 2 <= cell_width && std::abs(y) * 2 <= cell_height;
}

MeterSet::Extent MeterSet::extent(size_t m, size_t k) const {
  const Meter& at = piece(m, k);
  const auto corner = [&](float x, float y) { return at.frame.s * x + at.frame.t * y; };
  Extent out{at.p, disc_radius, {-1, -1, -1}};
  const auto grow = [&](const Vec3& c) {
    out.radius = std::max(out.radius, length(c));
    out.reach = {std::max(out.reach.x, std::abs(c.x)), std::max(out.reach.y, std::abs(c.y)),
                 std::max(out.reach.z, std::abs(c.z))};
  };
  if (on_surface()) {
    const MeterTriangle& t = triangles[first_triangle[m] + k];
    const Vec3 center = corner(t.centroid().x, t.centroid().y);
    out.center += center;
    for (const Vec3& c : {Vec3(), corner(t.second, 0), corner(t.third.x, t.third.y)}) grow(c - center);
  } else if (disc_radius == 0) {
    out.radius = 0.5f * std::sqrt(cell_width * cell_width + cell_height * cell_height);
    for (const float side : {-0.5f, 0.5f}) grow(corner(0.5f * cell_width, side * cell_height));
  }
  return out;
}

Meter MeterSet::sample(size_t m, const Vec2& u) const {
  if (!on_surface()) {
    Meter at = meters[m];
    const Vec2 disc = disc_radius > 0 ? square_to_disc(u) : Vec2{};
    at.p += disc_radius > 0 ? (at.frame.s * disc.x + at.frame.t * disc.y) * disc_radius
                            : at.frame.s * ((u.x - 0.5f) * cell_width) + at.frame.t * ((u.y - 0.5f) * cell_height);
    return at;
  }
  const auto begin = triangles.begin() + ptrdiff_t(first_triangle[m]),
             last = triangles.begin() + ptrdiff_t(first_triangle[m + 1]) - 1;
  const auto chosen = std::upper_bound(begin, last, u.x, [](float x, const MeterTriangle& t) { return x < t.up_to; });
  const float before = chosen == begin ? 0 : (chosen - 1)->up_to, share = chosen->up_to - before;
  const Vec2 b = square_to_triangle({share > 0 ? std::clamp((u.x - before) / share, 0.0f, 1.0f) : 0.5f, u.y});
  Meter at = chosen->at;
  at.p += at.frame.s * (b.x * chosen->second + b.y * chosen->third.x) + at.frame.t * (b.y * chosen->third.y);
  return at;
}

uint32_t MeterSet::index_of(uint32_t number) const {
  if (numbers.empty()) return number < count() ? number : UINT32_MAX;
  const auto at = std::lower_bound(numbers.begin(), numbers.end(), number);
  return at != numbers.end() && *at == number ? uint32_t(at - numbers.begin()) : UINT32_MAX;
}

size_t MeterSet::bytes() const {
  return meters.capacity() * sizeof(Meter) + triangles.capacity() * sizeof(MeterTriangle) +
         (first_triangle.capacity() + surface_triangle.capacity() + numbers.capacity()) * sizeof(uint32_t) +
         areas.capacity() * sizeof(double);
}

}  // namespace ups
