// Non-local means with known variances and features: each pixel becomes a weighted mean of those around it whose
// surroundings look the same within their noise (Rousselle, Knaus, Zwicker 2012, Adaptive Rendering with Non-Local
// Means Filtering, Eq. 6) and which see the same surface by normal, depth and albedo (as Rousselle, Manzi, Zwicker
// 2013; the terms are those of Schied et al. 2017, SVGF, 4.4). Colours are divided by albedo before and multiplied
// after, so that texture stays.
#include "ocio/smooth.h"

#include <algorithm>
#include <cmath>

#include "base/floating_point.h"

namespace ups::ocio {

namespace {

constexpr int reach = 8, patch = 3;        // pixels to each side: of what is averaged, of what is compared
constexpr float tolerance = 0.6f;          // of colour distances, in standard deviations: k of Rousselle 2012
constexpr float darkest_albedo = 0.05f;    // that colours are divided by
constexpr float albedo_width = 0.1f, depth_width = 0.01f;  // of the depth itself, beside its slope
constexpr float least_weight = 0.02f;

// 3 floats a pixel, or 1.
using Plane = std::vector<float>;

class Smoother {
 public:
  explicit Smoother(const ups_ocio_smooth_desc& d)
      : width_(int(d.width)), height_(int(d.height)), pixels_(size_t(d.width) * d.height) {
    color_.assign(d.luminance_rgb, d.luminance_rgb + 3 * pixels_);
    if (d.albedo_rgb) albedo_.assign(d.albedo_rgb, d.albedo_rgb + 3 * pixels_);
    if (d.normal) read_normals(d.normal);
    if (d.depth) read_depths(d.depth);
    read_variances(d.standard_error_rgb);
    divide_by_albedo();
    box_mean(variance_, 3, 1);
  }

  Plane run() {
    Plane sums(3 * pixels_), weights(pixels_);
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) add_neighbours(dx, dy, sums, weights);
    for (size_t i = 0; i < sums.size(); ++i) sums[i] = sums[i] / weights[i / 3] * divisor(i);
    return sums;
  }

 private:
  float divisor(size_t i) const { return albedo_.empty() ? 1 : std::max(albedo_[i], darkest_albedo); }

  void read_normals(const float* normals) {
    normal_.assign(normals, normals + 3 * pixels_);
    for (size_t p = 0; p < pixels_; ++p) {
      float* n = &normal_[3 * p];
      const float l = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      for (int k = 0; k < 3 && l > 0; ++k) n[k] /= l;
    }
  }

  // Slopes: the smaller one of both sides, so that an edge is not taken for a slope.
  void read_depths(const float* depths) {
    depth_.assign(depths, depths + pixels_);
    slope_.resize(2 * pixels_);
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        const auto step = [&](int dx, int dy) {
          return depth_[at(std::clamp(x + dx, 0, width_ - 1), std::clamp(y + dy, 0, height_ - 1))] - depth_[at(x, y)];
        };
        const float sides[4] = {step(1, 0), -step(-1, 0), step(0, 1), -step(0, -1)};
        for (size_t k = 0; k < 2; ++k) {
          const float a = sides[2 * k], b = sides[2 * k + 1];
          slope_[2 * at(x, y) + k] = std::abs(a) < std::abs(b) ? a : b;
        }
      }
  }

  // Where an error is not known few paths have found light: it is as large as what is around.
  void read_variances(const float* errors) {
    Plane around(3 * pixels_);
    for (size_t i = 0; i < around.size(); ++i) around[i] = color_[i] * color_[i];
    box_mean(around, 3, patch);
    variance_.resize(3 * pixels_);
    for (size_t i = 0; i < around.size(); ++i) variance_[i] = errors[i] >= 0 ? errors[i] * errors[i] : around[i];
  }

  void divide_by_albedo() {
    for (size_t i = 0; i < color_.size(); ++i) {
      const float d = divisor(i);
      color_[i] /= d, variance_[i] /= d * d;
    }
  }

  size_t at(int x, int y) const { return size_t(y) * size_t(width_) + size_t(x); }

  // Mean over the square of 2 r + 1 pixels about each, cut at the borders; rows, then columns.
  void box_mean(Plane& plane, int channels, int r) const {
    Plane line;
    const auto pass = [&](int count, size_t first, size_t stride) {
      line.resize(size_t(count));
      for (int i = 0; i < count; ++i) line[size_t(i)] = plane[first + size_t(i) * stride];
      for (int i = 0; i < count; ++i) {
        const int from = std::max(i - r, 0), to = std::min(i + r, count - 1);
        double sum = 0;  // anew: a running one would not come down again from a large value
        for (int k = from; k <= to; ++k) sum += line[size_t(k)];
        plane[first + size_t(i) * stride] = float(sum / (to - from + 1));
      }
    };
    const auto c = size_t(channels), w = size_t(width_);
    for (size_t y = 0; y < size_t(height_); ++y)
      for (size_t k = 0; k < c; ++k) pass(width_, y * w * c + k, c);
    for (size_t x = 0; x < w; ++x)
      for (size_t k = 0; k < c; ++k) pass(height_, x * c + k, w * c);
  }

  // Squared distance of colours less what noise makes of it, in units of that noise.
  float color_distance(size_t p, size_t q) const {
    float sum = 0;
    for (size_t k = 0; k < 3; ++k) {
      const float a = color_[3 * p + k], va = variance_[3 * p + k], vb = variance_[3 * q + k],
                  d = a - color_[3 * q + k];
      sum += (d * d - (va + std::min(va, vb))) / (1e-8f + 1e-6f * a * a + tolerance * tolerance * (va + vb));
    }
    return sum / 3;
  }

  // Of the surfaces that both pixels see: 0 where they do not agree.
  float same_surface(size_t p, size_t q, int dx, int dy) const {
    float exponent = 0, facing = 1;
    if (!albedo_.empty())
      for (size_t k = 0; k < 3; ++k) {
        const float d = (albedo_[3 * p + k] - albedo_[3 * q + k]) / albedo_width;
        exponent += 0.5f * d * d;
      }
    if (!depth_.empty() && depth_[p] != depth_[q]) {
      if (depth_[p] < 0 || depth_[q] < 0) return 0;
      const float along = std::abs(slope_[2 * p] * float(dx) + slope_[2 * p + 1] * float(dy));
      exponent += std::abs(depth_[q] - depth_[p]) / (along + depth_width * depth_[p] + 1e-9f);
    }
    if (!normal_.empty()) {
      const float *a = &normal_[3 * p], *b = &normal_[3 * q];
      const bool none = a[0] == 0 && a[1] == 0 && a[2] == 0 && b[0] == 0 && b[1] == 0 && b[2] == 0;
      facing = none ? 1 : std::max(0.0f, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
      for (int k = 0; k < 5; ++k) facing *= facing;  // to the 32nd
    }
    return facing * std::exp(-exponent);
  }

  void add_neighbours(int dx, int dy, Plane& sums, Plane& weights) {
    const int x0 = std::max(0, -dx), x1 = std::min(width_, width_ - dx), y0 = std::max(0, -dy),
              y1 = std::min(height_, height_ - dy);
    distance_.assign(pixels_, 0);
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) distance_[at(x, y)] = color_distance(at(x, y), at(x + dx, y + dy));
    if (dx != 0 || dy != 0) box_mean(distance_, 1, patch);
    const float farthest = -std::log(least_weight);
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        const size_t p = at(x, y), q = at(x + dx, y + dy);
        float weight = 1;
        if (p != q) {
          if (!(distance_[p] <= farthest)) continue;  // squares of what shines like the sun may overflow
          weight = std::exp(-std::max(0.0f, distance_[p])) * same_surface(p, q, dx, dy);
          if (weight < least_weight) continue;
        }
        for (size_t k = 0; k < 3; ++k) sums[3 * p + k] += weight * color_[3 * q + k];
        weights[p] += weight;
      }
  }

  const int width_, height_;
  const size_t pixels_;
  Plane color_, variance_, albedo_, normal_, depth_, slope_;  // color and variance: divided by albedo
  Plane distance_;
};

}  // namespace

std::vector<float> smooth(const ups_ocio_smooth_desc& desc) {
  const TrapsMasked masked;  // squares of what is brighter than 1e19 are infinite, and so are distances to it
  return Smoother(desc).run();
}

}  // namespace ups::ocio
