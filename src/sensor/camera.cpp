// The four projections: see camera.h. Called by transport for eye paths and camera connections.
#include "sensor/camera.h"

#include "base/frame.h"

namespace ups {

namespace {

// Distance from the image circle's middle, its radius being 1, of light at `angle` from the axis; and the inverse.
float radius_of(Projection p, float angle) {
  return p == Projection::equidistant ? angle * (2 * inv_pi) : std::sqrt(2.0f) * std::sin(0.5f * angle);
}
float angle_of(Projection p, float radius) {
  return p == Projection::equidistant ? radius * (0.5f * pi) : 2 * std::asin(std::min(radius * std::sqrt(0.5f), 1.0f));
}

double cos_at(uint32_t row, double u, uint32_t rows) { return std::cos(pi_d * (row + u) / rows); }

}  // namespace

Camera::Camera(const Affine& to_scene, uint32_t width, uint32_t height, float vertical_fov_rad, bool illuminance,
               Projection projection, uint32_t layers)
    : position_(to_scene.column(3)), width_(width), height_(height), layers_(layers), projection_(projection),
      illuminance_(illuminance) {
  const Vec3d back = normalize(to_scene.column(2));
  Vec3d up = to_scene.column(1) - back * dot(to_scene.column(1), back);
  up = length2(up) > 0 ? normalize(up) : Vec3d(Frame(Vec3(back)).t);
  right_ = Vec3(cross(up, back));
  up_ = Vec3(up);
  forward_ = Vec3(-back);
  if (projection == Projection::perspective) {
    half_height_ = float(std::tan(0.5 * double(vertical_fov_rad)));
    half_width_ = float(double(half_height_) * width / height);
    pixel_area_ = (2 * half_width_ / float(width)) * (2 * half_height_ / float(height));
  } else if (is_fisheye()) {
    pixel_area_ = (2 / float(height)) * (2 / float(height));
  } else {
    for (uint32_t row = 0; row < height; ++row)
      row_pdf_.push_back(float(width / (2 * pi_d * (cos_at(row, 0, height) - cos_at(row, 1, height)))));
  }
}

Vec2 Camera::on_circle(float x, float y) const {
  return {(2 * x - float(width_)) / float(height_), (float(height_) - 2 * y) / float(height_)};
}

std::optional<Vec3> Camera::fisheye_ray(const Vec2& at) const {
  const float r = std::hypot(at.x, at.y);
  if (r > 1) return std::nullopt;
  if (!(r > 0)) return forward_;
  const float angle = angle_of(projection_, r);
  return normalize(forward_ * std::cos(angle) + (right_ * at.x + up_ * at.y) * (std::sin(angle) / r));
}

std::optional<Vec2> Camera::fisheye_point(const Vec3& d) const {
  const Vec2 across{dot(d, right_), dot(d, up_)};
  const float sine = std::hypot(across.x, across.y), angle = std::atan2(sine, dot(d, forward_));
  if (!(angle <= 0.5f * pi)) return std::nullopt;
  const float scale = sine > 0 ? radius_of(projection_, angle) / sine : 0;
  return Vec2{across.x * scale, across.y * scale};
}

// Uniform in longitude and in the cosine from the zenith.
Vec3 Camera::panorama_ray(float x, uint32_t row, float u) const {
  const double above = cos_at(row, 0, height_), below = cos_at(row, 1, height_), cosine = above + u * (below - above),
               sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)),
               longitude = 2 * pi_d * double(x) / width_ - pi_d;
  return normalize(forward_ * float(sine * std::cos(longitude)) + right_ * float(sine * std::sin(longitude)) +
                   up_ * float(cosine));
}

uint32_t Camera::panorama_row(const Vec3& d) const {
  const float from_zenith = std::atan2(std::hypot(dot(d, right_), dot(d, forward_)), dot(d, up_));
  return std::min(uint32_t(from_zenith * inv_pi * float(height_)), height_ - 1);
}

std::optional<Vec3> Camera::ray(uint32_t x, uint32_t y, const Vec2& u) const {
  if (projection_ == Projection::panorama) return panorama_ray(float(x) + u.x, y, u.y);
  if (is_fisheye()) return fisheye_ray(on_circle(float(x) + u.x, float(y) + u.y));
  const float across = 2 * (float(x) + u.x) / float(width_) - 1;
  const float down = 2 * (float(y) + u.y) / float(height_) - 1;
  return normalize(forward_ + right_ * (across * half_width_) - up_ * (down * half_height_));
}

// A fisheye's solid angle by area, sin(angle) d(angle) / (r dr): (pi/2)^2 sin(angle) / angle, or 2.
float Camera::pdf_w(const Vec3& direction) const {
  if (projection_ == Projection::panorama) return row_pdf_[panorama_row(direction)];
  const float cos_axis = dot(direction, forward_);
  if (projection_ == Projection::perspective)
    return cos_axis > 0 ? 1 / (pixel_area_ * cos_axis * cos_axis * cos_axis) : 0;
  const float sine = std::hypot(dot(direction, right_), dot(direction, up_)), angle = std::atan2(sine, cos_axis);
  if (!(angle <= 0.5f * pi)) return 0;
  if (projection_ == Projection::equisolid) return 1 / (2 * pixel_area_);
  return 1 / (0.25f * pi * pi * (angle > 1e-3f ? sine / angle : 1) * pixel_area_);
}

std::optional<uint32_t> Camera::pixel_at(float x, float y) const {
  if (!(x >= 0 && x < float(width_) && y >= 0 && y < float(height_))) return std::nullopt;
  return uint32_t(y) * width_ + uint32_t(x);
}

std::optional<uint32_t> Camera::pixel_of(const Vec3& direction) const {
  if (projection_ == Projection::panorama) {
    const float turns = std::atan2(dot(direction, right_), dot(direction, forward_)) * (0.5f * inv_pi) + 0.5f;
    return panorama_row(direction) * width_ + std::min(uint32_t(turns * float(width_)), width_ - 1);
  }
  if (is_fisheye()) {
    const auto at = fisheye_point(direction);
    if (!at) return std::nullopt;
    return pixel_at(0.5f * (float(width_) + at->x * float(height_)), 0.5f * (1 - at->y) * float(height_));
  }
  const float cos_axis = dot(direction, forward_);
  if (!(cos_axis > 0)) return std::nullopt;
  const float across = dot(direction, right_) / (cos_axis * half_width_);
  const float down = -dot(direction, up_) / (cos_axis * half_height_);
  return pixel_at(0.5f * (across + 1) * float(width_), 0.5f * (down + 1) * float(height_));
}

bool Camera::sees(uint32_t x, uint32_t y) const {
  if (!is_fisheye()) return true;
  // The point of the pixel that is nearest to the middle.
  const float middle_x = 0.5f * float(width_), middle_y = 0.5f * float(height_);
  const Vec2 at = on_circle(std::clamp(middle_x, float(x), float(x) + 1), std::clamp(middle_y, float(y), float(y) + 1));
  return at.x * at.x + at.y * at.y < 1;
}

}  // namespace ups
