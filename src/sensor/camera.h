// Cameras: pixels to rays, directions to pixels, and the densities of both, by projection.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec.h"

namespace ups {

enum class Projection { perspective, equidistant, equisolid, panorama };  // as UPS_PERSPECTIVE and those after it

// A fisheye's image circle, 90 degrees about the axis, fills the height. Outside of it nothing is seen: a pixel on its
// rim counts what lies outside as black. A panorama holds all directions, longitude by latitude; its middle column is
// the axis, its top row straight up.
class Camera {
 public:
  // to_scene: looks along local -Z, +Y is up; scale is ignored, the axes are orthonormalised (z first). The field of
  // view is a perspective camera's. layers: UPS_LAYER_*.
  Camera(const Affine& to_scene, uint32_t width, uint32_t height, float vertical_fov_rad, bool illuminance,
         Projection projection = Projection::perspective, uint32_t layers = 0);

  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  uint32_t pixel_count() const { return width_ * height_; }
  bool illuminance() const { return illuminance_; }
  uint32_t layers() const { return layers_; }
  Projection projection() const { return projection_; }
  Vec3 position() const { return position_; }
  Vec3 forward() const { return forward_; }

  // Direction through a point of pixel (x, y), u in [0, 1)^2; row 0 is the top. None outside of the image circle.
  std::optional<Vec3> ray(uint32_t x, uint32_t y, const Vec2& u) const;
  // Density per solid angle of a direction within its own pixel: uniform over the pixel's area on the image, on a
  // panorama over its solid angle. An eye path weighs 1, so it is the pixel's importance, too.
  float pdf_w(const Vec3& direction) const;
  // The pixel that sees a direction, if any.
  std::optional<uint32_t> pixel_of(const Vec3& direction) const;
  // Does any part of the pixel lie in the image circle?
  bool sees(uint32_t x, uint32_t y) const;

 private:
  bool is_fisheye() const { return projection_ == Projection::equidistant || projection_ == Projection::equisolid; }
  std::optional<uint32_t> pixel_at(float x, float y) const;
  Vec2 on_circle(float x, float y) const;  // of a point in pixels: in radii of the image circle, +y up
  std::optional<Vec3> fisheye_ray(const Vec2& at) const;
  std::optional<Vec2> fisheye_point(const Vec3& direction) const;  // the inverse
  Vec3 panorama_ray(float x, uint32_t row, float u) const;
  uint32_t panorama_row(const Vec3& direction) const;

  Vec3 position_, right_, up_, forward_;
  uint32_t width_, height_, layers_;
  float half_width_ = 0, half_height_ = 0;  // of a perspective's image plane at distance 1
  float pixel_area_ = 0;                    // there, or of a fisheye where the circle's radius is 1
  std::vector<float> row_pdf_;              // of a panorama
  Projection projection_;
  bool illuminance_;
};

}  // namespace ups
