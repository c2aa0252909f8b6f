// An image on a surface: linear floats, bilinear, repeating in u and v. glTF's v = 0 is row 0.
#pragma once
#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "base/vec.h"

namespace ups {

class Texture {
 public:
  Texture(uint32_t width, uint32_t height, uint32_t channels, std::vector<float> texels);
  Rgb rgb(const Vec2& uv) const;    // 1-channel textures: grey
  float first(const Vec2& uv) const;
  float last(const Vec2& uv) const;  // alpha of 4-channel textures
  float min_first() const { return min_first_; }
  bool coloured() const { return coloured_; }
  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  uint32_t channels() const { return channels_; }
  size_t texel_count() const { return size_t(width_) * height_ * channels_; }  // all channels
  float texel(size_t i) const {  // as they were given
    if (indices_.empty()) return texels_[i];
    return by_colour_ ? colour(i / channels_)[i % channels_] : values_[indices_[i]];
  }
  size_t bytes() const {
    return sizeof *this + (texels_.capacity() + values_.capacity()) * sizeof(float) + indices_.capacity();
  }

 private:
  template <class Texel> auto blend(const Vec2& uv, const Texel& texel) const;
  float channel(const Vec2& uv, uint32_t k) const;
  const float* colour(size_t texel) const { return &values_[4 * size_t(indices_[texel])]; }
  template <size_t N> bool number();  // parts of N floats; false where too many of them differ
  uint32_t width_, height_, channels_;
  // Of no more than 256 different values, as those of 8-bit files are, numbers of bytes that stay in the caches. Of no
  // more than 256 different colours, as of tiles, a number for all channels; four values each.
  std::vector<float> texels_, values_;
  std::vector<uint8_t> indices_;
  bool by_colour_ = false;
  float min_first_ = 1;
  bool coloured_ = false;
};

}  // namespace ups
