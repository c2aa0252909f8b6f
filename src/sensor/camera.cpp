// Pinhole camera on an image plane at distance 1: see camera.h. Called by transport for eye paths and camera
// connections.
#include "sensor/camera.h"

#include "base/frame.h"

namespace ups {

Camera::Camera(const Affine& to_scene, uint32_t width, uint32_t height, float vertical_fov_rad, bool illuminance)
    : position_(to_scene.column(3)), width_(width), height_(height), illuminance_(illuminance) {
  const Vec3d back = normalize(to_scene.column(2));
  Vec3d up = to_scene.column(1) - back * dot(to_scene.column(1), back);
  up = length2(up) > 0 ? normalize(up) : Vec3d(Frame(Vec3(back)).t);
  right_ = Vec3(cross(up, back));
  up_ = Vec3(up);
  forward_ = Vec3(-back);
  half_height_ = float(std::tan(0.5 * double(vertical_fov_rad)));
  half_width_ = float(double(half_height_) * width / height);
  pixel_area_ = (2 * half_width_ / float(width)) * (2 * half_height_ / float(height));
}

Vec3 Camera::ray(uint32_t x, uint32_t y, const Vec2& u) const {
  const float across = 2 * (float(x) + u.x) / float(width_) - 1;
  const float down = 2 * (float(y) + u.y) / float(height_) - 1;
  return normalize(forward_ + right_ * (across * half_width_) - up_ * (down * half_height_));
}

float Camera::pdf_w(const Vec3& direction) const {
  const float cos_axis = dot(direction, forward_);
  return cos_axis > 0 ? 1 / (pixel_area_ * cos_axis * cos_axis * cos_axis) : 0;
}

std::optional<uint32_t> Camera::pixel_of(const Vec3& direction) const {
  const float cos_axis = dot(direction, forward_);
  if (!(cos_axis > 0)) return std::nullopt;
  const float across = dot(direction, right_) / (cos_axis * half_width_);
  const float down = -dot(direction, up_) / (cos_axis * half_height_);
  const float x = 0.5f * (across + 1) * float(width_), y = 0.5f * (down + 1) * float(height_);
  if (!(x >= 0 && x < float(width_) && y >= 0 && y < float(height_))) return std::nullopt;
  return uint32_t(y) * width_ + uint32_t(x);
}

}  // namespace ups
