// UPS for C++17: what needs no scene: the grid of EN 12464-1, position indices, UGR by its formula. See ups.hpp.
#ifndef UPS_HPP_STANDARDS_HPP
#define UPS_HPP_STANDARDS_HPP

#include "base.hpp"

namespace ups {
inline namespace v0_1 {

struct En12464Desc : ups_en12464_desc {
  En12464Desc() noexcept { ups_en12464_desc_init(this, sizeof(ups_en12464_desc)); }
  // 2 values a corner: x, y.
  explicit En12464Desc(Span<const double> corners) : En12464Desc() {
    corner_count = detail::count(corners.size(), 2, "corners");
    corners_m = corners.data();
  }
  // The corners of all holes, one after the other, and how many each has.
  void set_holes(Span<const double> corners, Span<const std::uint32_t> corner_counts) {
    std::size_t values = 0;
    for (const std::uint32_t corners_of_hole : corner_counts) values += std::size_t{2} * corners_of_hole;
    detail::expect(corners.size(), values, "corners");
    hole_count = detail::count(corner_counts.size(), 1, "corner_counts");
    hole_corners_m = corners.data();
    hole_corner_counts = corner_counts.data();
  }
};

struct En12464Grid {
  ups_en12464_info info;
  std::vector<ups_en12464_point> points;  // column fastest
};

inline En12464Grid en12464_grid(const En12464Desc &desc) {
  En12464Grid out{};
  out.info.struct_size = sizeof out.info;
  out.points = detail::list<ups_en12464_point>(ups_en12464_grid, &desc, &out.info);
  return out;
}

// Of directions in the eye's frame, 3 floats each.
inline std::vector<float> glare_get_position_index(ups_position_index kind, Span<const float> directions) {
  std::vector<float> out(detail::count(directions.size(), 3, "directions"));
  check(ups_glare_get_position_index(kind, directions.data(), out.size(), out.data()));
  return out;
}

// Of sources by their luminance, solid angle and position index: as many values in each.
inline float glare_get_ugr(Span<const float> luminance_cd_m2, Span<const float> solid_angle_sr,
                           Span<const float> position_index, double background_cd_m2) {
  detail::expect(solid_angle_sr.size(), luminance_cd_m2.size(), "solid_angle_sr");
  detail::expect(position_index.size(), luminance_cd_m2.size(), "position_index");
  return detail::value<float>(ups_glare_get_ugr, luminance_cd_m2.data(), solid_angle_sr.data(), position_index.data(),
                              luminance_cd_m2.size(), background_cd_m2);
}

}  // namespace v0_1
}  // namespace ups

#endif
