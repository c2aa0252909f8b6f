// See lightmap.h. Polygons are cut by one half-plane after another (Sutherland, Hodgman 1974).
#include "scene/lightmap.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"

namespace ups {

namespace {

constexpr double least_overlap = 1e-6;  // texels

using Weights = std::array<double, 3>;

struct Corner {
  Vec2d p;
  Weights weights{};
};
using Polygon = std::vector<Corner>;

double twice_area(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Corner between(const Corner& a, const Corner& b, double t) {
  Corner c{{a.p.x + t * (b.p.x - a.p.x), a.p.y + t * (b.p.y - a.p.y)}};
  for (size_t k = 0; k < 3; ++k) c.weights[k] = a.weights[k] + t * (b.weights[k] - a.weights[k]);
  return c;
}

// Keeps where height(corner) >= 0.
template <class Height>
void cut(const Polygon& in, Polygon& out, const Height& height) {
  out.clear();
  for (size_t i = 0; i < in.size(); ++i) {
    const Corner &a = in[i], &b = in[i + 1 < in.size() ? i + 1 : 0];
    const double ha = height(a.p), hb = height(b.p);
    if (ha >= 0) out.push_back(a);
    if ((ha > 0 && hb < 0) || (ha < 0 && hb > 0)) out.push_back(between(a, b, ha / (ha - hb)));
  }
}

// Columns or rows that an interval meets.
struct Range {
  uint32_t begin, end;
};
Range texels_of(double low, double high, uint32_t count) {
  const double begin = std::clamp(std::floor(low), 0.0, double(count));
  return {uint32_t(begin), uint32_t(std::clamp(std::ceil(high), begin, double(count)))};
}

template <double Vec2d::*axis>
Range range_of(const Polygon& polygon, uint32_t count) {
  double low = INFINITY, high = -INFINITY;
  for (const Corner& c : polygon) low = std::min(low, c.p.*axis), high = std::max(high, c.p.*axis);
  return polygon.empty() ? Range{0, 0} : texels_of(low, high, count);
}

template <double Vec2d::*axis>
void cut_to(const Polygon& in, double low, double high, Polygon& buffer, Polygon& out) {
  cut(in, buffer, [&](const Vec2d& p) { return p.*axis - low; });
  cut(buffer, out, [&](const Vec2d& p) { return high - p.*axis; });
}

bool apart(const std::array<Vec2d, 3>& a, const std::array<Vec2d, 3>& b, double Vec2d::*axis) {
  return std::max({a[0].*axis, a[1].*axis, a[2].*axis}) <= std::min({b[0].*axis, b[1].*axis, b[2].*axis});
}

double overlap(const std::array<Vec2d, 3>& a, const std::array<Vec2d, 3>& b) {
  if (apart(a, b, &Vec2d::x) || apart(b, a, &Vec2d::x) || apart(a, b, &Vec2d::y) || apart(b, a, &Vec2d::y)) return 0;
  Polygon polygon = {{a[0]}, {a[1]}, {a[2]}}, buffer;
  const double turn = twice_area(b[0], b[1], b[2]) < 0 ? -1 : 1;
  for (size_t i = 0; i < 3; ++i) {
    cut(polygon, buffer, [&](const Vec2d& p) { return turn * twice_area(b[i], b[(i + 1) % 3], p); });
    polygon.swap(buffer);
  }
  double sum = 0;
  for (size_t i = 2; i < polygon.size(); ++i) sum += twice_area(polygon[0].p, polygon[i - 1].p, polygon[i].p);
  return 0.5 * std::abs(sum);
}

}  // namespace

// Who lets surfaces share a texel may mean it, but not four of them everywhere, as the UVs of a tiled texture do.
void LightmapCut::cover(double texels) {
  constexpr double most_layers = 4;
  constexpr size_t most_parts = size_t(1) << 26;
  covered_ += texels;
  if (!(covered_ <= most_layers * width_ * height_ + 1))
    fail_argument("the triangles cover its texels more than " + std::to_string(int(most_layers)) +
                  " times over: they need UVs of their own, where those of a tiled texture were given");
  if (parts_.size() > most_parts)
    fail_argument("the texels cut the triangles into more than " + std::to_string(most_parts) +
                  " parts; fewer texels or triangles would be right");
}

void LightmapCut::add(uint32_t triangle, const std::array<Vec2d, 3>& uv) {
  Polygon whole, row, cell, buffer;
  for (size_t k = 0; k < 3; ++k) {
    whole.push_back({{uv[k].x * width_, uv[k].y * height_}});
    whole.back().weights[k] = 1;
  }
  if (twice_area(whole[0].p, whole[1].p, whole[2].p) == 0) {
    ++flat_;
    return;
  }
  const Range rows = range_of<&Vec2d::y>(whole, height_);
  for (uint32_t y = rows.begin; y < rows.end; ++y) {
    cut_to<&Vec2d::y>(whole, y, y + 1.0, buffer, row);
    const Range columns = range_of<&Vec2d::x>(row, width_);
    for (uint32_t x = columns.begin; x < columns.end; ++x) {
      cut_to<&Vec2d::x>(row, x, x + 1.0, buffer, cell);
      for (size_t i = 2; i < cell.size(); ++i) {
        const Corner &a = cell[0], &b = cell[i - 1], &c = cell[i];
        const double twice = twice_area(a.p, b.p, c.p);
        if (twice == 0) continue;
        cover(0.5 * std::abs(twice));
        parts_.push_back({y * width_ + x, triangle, {a.weights, b.weights, c.weights}});
        uvs_.push_back({a.p, b.p, c.p});
      }
    }
  }
}

std::vector<TexelPart> LightmapCut::take() {
  std::vector<size_t> order(parts_.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](size_t i, size_t j) { return parts_[i].texel < parts_[j].texel; });
  for (size_t i = 0; i < order.size(); ++i) {  // in place, a cycle after another: a copy may be gigabytes
    const TexelPart part = parts_[i];
    const std::array<Vec2d, 3> uv = uvs_[i];
    size_t to = i;
    for (size_t from = order[to]; from != i; to = from, from = order[to])
      parts_[to] = parts_[from], uvs_[to] = uvs_[from], order[to] = to;
    parts_[to] = part, uvs_[to] = uv, order[to] = to;
  }
  find_overlaps();
  uvs_ = std::vector<std::array<Vec2d, 3>>();
  return std::move(parts_);
}

// In a texel of many parts each is compared with some of those after it: what lies twice shows elsewhere, too.
void LightmapCut::find_overlaps() {
  constexpr size_t most = 64;
  for (size_t begin = 0, end = 0; begin < parts_.size(); begin = end) {
    while (end < parts_.size() && parts_[end].texel == parts_[begin].texel) ++end;
    bool found = false;
    for (size_t i = begin; i < end && !found; ++i)
      for (size_t j = i + 1; j < std::min(end, i + most) && !found; ++j) {
        if (parts_[i].triangle == parts_[j].triangle || overlap(uvs_[i], uvs_[j]) < least_overlap) continue;
        if (overlaps_.texels++ == 0)
          overlaps_ = {1, parts_[i].texel, parts_[i].triangle, parts_[j].triangle};
        found = true;
      }
  }
}

}  // namespace ups
