// What value has an image at (u, v)? Bilinear between texel centres at (i + 0.5) / size, repeating.
#include "geometry/texture.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace ups {
namespace {

struct Tap {
  uint32_t first, second;
  float fraction;
};

// The two texels about a coordinate, and the weight of the second. In double, so that large coordinates keep their
// place.
Tap tap(float coordinate, uint32_t size) {
  double wrapped = double(coordinate) - std::floor(double(coordinate));
  if (!(wrapped >= 0 && wrapped < 1)) wrapped = 0;  // not finite
  const double x = wrapped * size - 0.5, below = std::floor(x);
  const uint32_t second = uint32_t(below + 1) % size;
  return {below < 0 ? size - 1 : uint32_t(below), second, float(x - below)};
}

}  // namespace

Texture::Texture(uint32_t width, uint32_t height, uint32_t channels, std::vector<float> texels)
    : width_(width), height_(height), channels_(channels), texels_(std::move(texels)) {
  if (width == 0 || height == 0) fail_argument("texture: width and height must be at least 1");
  if (channels != 1 && channels != 3 && channels != 4)
    fail_argument("texture: channel_count is " + std::to_string(channels) + "; it must be 1, 3 or 4");
  if (texels_.size() != size_t(width) * height * channels)
    fail_argument("texture: expected width * height * channel_count texels, got " + std::to_string(texels_.size()));
  min_first_ = texels_[0];
  for (size_t i = 0; i < texels_.size(); i += channels) {
    min_first_ = std::min(min_first_, texels_[i]);
    if (channels >= 3) coloured_ = coloured_ || texels_[i] != texels_[i + 1] || texels_[i] != texels_[i + 2];
  }
}

template <int C>
void Texture::fetch(const Vec2& uv, const int (&channel)[C], float (&out)[C]) const {
  const Tap x = tap(uv.x, width_), y = tap(uv.y, height_);
  const float* row0 = texels_.data() + size_t(y.first) * width_ * channels_;
  const float* row1 = texels_.data() + size_t(y.second) * width_ * channels_;
  const size_t i = size_t(x.first) * channels_, j = size_t(x.second) * channels_;
  for (int c = 0; c < C; ++c) {
    const int k = channel[c];
    const float a = row0[i + k] * (1 - x.fraction) + row0[j + k] * x.fraction;
    const float b = row1[i + k] * (1 - x.fraction) + row1[j + k] * x.fraction;
    out[c] = a * (1 - y.fraction) + b * y.fraction;
  }
}

Rgb Texture::rgb(const Vec2& uv) const {
  if (channels_ == 1) return Rgb(first(uv));
  float c[3];
  fetch(uv, {0, 1, 2}, c);
  return {c[0], c[1], c[2]};
}

float Texture::first(const Vec2& uv) const {
  float c[1];
  fetch(uv, {0}, c);
  return c[0];
}

float Texture::last(const Vec2& uv) const {
  float c[1];
  fetch(uv, {int(channels_) - 1}, c);
  return c[0];
}

}  // namespace ups
