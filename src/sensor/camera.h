// Perspective pinhole camera: pixels to rays, points to pixels, and the densities of both.
#pragma once
#include <cstdint>
#include <optional>

#include "base/vec.h"

namespace ups {

class Camera {
 public:
  // to_scene: looks along local -Z, +Y is up; scale is ignored, the axes are orthonormalised (z first).
  Camera(const Affine& to_scene, uint32_t width, uint32_t height, float vertical_fov_rad, bool illuminance);

  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  uint32_t pixel_count() const { return width_ * height_; }
  bool illuminance() const { return illuminance_; }
  Vec3 position() const { return position_; }
  Vec3 forward() const { return forward_; }

  // Direction through a point of pixel (x, y), u in [0, 1)^2; row 0 is the top.
  Vec3 ray(uint32_t x, uint32_t y, const Vec2& u) const;
  // Density per solid angle of a direction within its own pixel (box filter: the pixel's area on the image plane).
  float pdf_w(const Vec3& direction) const;
  // The pixel that sees a direction, if any.
  std::optional<uint32_t> pixel_of(const Vec3& direction) const;

 private:
  Vec3 position_, right_, up_, forward_;
  uint32_t width_, height_;
  float half_width_, half_height_, pixel_area_;  // of the image plane at distance 1
  bool illuminance_;
};

}  // namespace ups
