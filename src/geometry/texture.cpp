// What value has an image at (u, v)? Bilinear between texel centres at (i + 0.5) / size, repeating.
#include "geometry/texture.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/lanes.h"

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
  by_colour_ = (channels == 3 && number<3>()) || (channels == 4 && number<4>());
  if (by_colour_ || number<1>()) texels_ = std::vector<float>();  // which, other than {}, gives back the memory
}

template <size_t N>
bool Texture::number() {
  using Part = std::array<uint32_t, N>;
  std::array<int16_t, 1024> numbers;  // of the parts by a hash of their bits, open addressing
  numbers.fill(-1);
  std::vector<Part> parts;
  const auto number_of = [&](const Part& part) {
    uint32_t hash = 0;
    for (const uint32_t bits : part) hash = (hash ^ bits) * 0x9e3779b1u;
    for (size_t at = hash >> 22;; at = (at + 1) % numbers.size()) {
      if (numbers[at] < 0) {
        numbers[at] = int16_t(parts.size());
        parts.push_back(part);
      }
      if (parts[size_t(numbers[at])] == part) return size_t(numbers[at]);
    }
  };
  std::vector<uint8_t> indices;
  indices.reserve(texels_.size() / N);
  for (size_t i = 0; i < texels_.size(); i += N) {
    Part part;
    for (size_t k = 0; k < N; ++k) part[k] = std::bit_cast<uint32_t>(texels_[i + k]);
    indices.push_back(uint8_t(number_of(part)));
    if (parts.size() > 256) return false;
  }
  constexpr size_t stride = N == 1 ? 1 : 4;
  values_.resize(parts.size() * stride);
  for (size_t i = 0; i < parts.size(); ++i)
    for (size_t k = 0; k < N; ++k) values_[i * stride + k] = std::bit_cast<float>(parts[i][k]);
  indices_ = std::move(indices);
  return true;
}

// texel(i): what is asked for of the i-th one: a float, a colour or four floats, each with the bits of its own.
template <class Texel>
auto Texture::blend(const Vec2& uv, const Texel& texel) const {
  const Tap x = tap(uv.x, width_), y = tap(uv.y, height_);
  const size_t row0 = size_t(y.first) * width_, row1 = size_t(y.second) * width_;
  const auto a = texel(row0 + x.first) * (1 - x.fraction) + texel(row0 + x.second) * x.fraction;
  const auto b = texel(row1 + x.first) * (1 - x.fraction) + texel(row1 + x.second) * x.fraction;
  return a * (1 - y.fraction) + b * y.fraction;
}

Rgb Texture::rgb(const Vec2& uv) const {
  if (channels_ == 1) return Rgb(first(uv));
  if (by_colour_) {
    const Float4 c = blend(uv, [this](size_t i) { return four_at(colour(i)); });
    return {c[0], c[1], c[2]};
  }
  const auto of = [&](const auto& value) {
    return blend(uv, [&](size_t i) {
      const size_t at = i * channels_;
      return Rgb(value(at), value(at + 1), value(at + 2));
    });
  };
  return indices_.empty() ? of([this](size_t i) { return texels_[i]; })
                          : of([this](size_t i) { return values_[indices_[i]]; });
}

float Texture::channel(const Vec2& uv, uint32_t k) const {
  if (by_colour_) return blend(uv, [&](size_t i) { return colour(i)[k]; });
  if (indices_.empty()) return blend(uv, [&](size_t i) { return texels_[i * channels_ + k]; });
  return blend(uv, [&](size_t i) { return values_[indices_[i * channels_ + k]]; });
}

float Texture::first(const Vec2& uv) const { return channel(uv, 0); }
float Texture::last(const Vec2& uv) const { return channel(uv, channels_ - 1); }

}  // namespace ups
