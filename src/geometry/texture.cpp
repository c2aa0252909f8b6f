// What value has an image at (u, v)? Bilinear between texel centres at (i + 0.5) / size, repeating.
#include "geometry/texture.h"

#include <algorithm>
#include <array>
#include <bit>
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
  double wrapped = 0;  // beyond 2^24 floats have no fraction
  if (std::abs(coordinate) < 0x1p24f) {
    wrapped = double(coordinate) - int32_t(coordinate);
    if (wrapped < 0) wrapped += 1;
    if (wrapped >= 1) wrapped = 0;
  }
  const double x = wrapped * size - 0.5;
  if (x < 0) return {size - 1, 0, float(x + 1)};
  const auto below = uint32_t(x);
  return {below, below + 1 == size ? 0 : below + 1, float(x - below)};
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
  if (index_texels()) texels_ = std::vector<float>();  // which, other than {}, gives back the memory
}

bool Texture::index_texels() {
  std::array<int16_t, 1024> numbers;  // of the values by a hash of their bits, open addressing
  numbers.fill(-1);
  const auto number = [&](float texel) {
    const auto bits = std::bit_cast<uint32_t>(texel);
    for (size_t at = bits * 0x9e3779b1u >> 22;; at = (at + 1) % numbers.size()) {
      if (numbers[at] < 0) {
        numbers[at] = int16_t(values_.size());
        values_.push_back(texel);
      }
      if (std::bit_cast<uint32_t>(values_[size_t(numbers[at])]) == bits) return size_t(numbers[at]);
    }
  };
  std::vector<uint8_t> indices;
  indices.reserve(texels_.size());
  for (const float t : texels_) {
    indices.push_back(uint8_t(number(t)));
    if (values_.size() > 256) return false;
  }
  indices_ = std::move(indices);
  return true;
}

template <int C>
void Texture::fetch(const Vec2& uv, const int (&channel)[C], float (&out)[C]) const {
  if (indices_.empty())
    fetch(uv, channel, [this](size_t i) { return texels_[i]; }, out);
  else
    fetch(uv, channel, [this](size_t i) { return values_[indices_[i]]; }, out);
}

template <int C, class Texel>
void Texture::fetch(const Vec2& uv, const int (&channel)[C], const Texel& texel, float (&out)[C]) const {
  const Tap x = tap(uv.x, width_), y = tap(uv.y, height_);
  const size_t row0 = size_t(y.first) * width_ * channels_, row1 = size_t(y.second) * width_ * channels_;
  const size_t i = size_t(x.first) * channels_, j = size_t(x.second) * channels_;
  for (int c = 0; c < C; ++c) {
    const int k = channel[c];
    const float a = texel(row0 + i + k) * (1 - x.fraction) + texel(row0 + j + k) * x.fraction;
    const float b = texel(row1 + i + k) * (1 - x.fraction) + texel(row1 + j + k) * x.fraction;
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
