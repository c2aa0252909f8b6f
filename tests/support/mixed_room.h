// A room with a little of everything, in any unit of length and at any place.
#pragma once
#include "expect_lx.h"

namespace ups::test {

// Where light comes from. mixed: an area emitter, and candelas that grow with the square of the lengths.
enum class Lights { mixed, area, candela };

// A little of everything, lengths times `scale`, moved by `offset`.
struct MixedRoom {
  Scene scene;
  Sensor points, cells, camera;

  MixedRoom(int threads, double scale, const P3& offset, bool with_camera, Lights lights = Lights::mixed) : scene(threads) {
    const auto at = [&](double x, double y, double z) { return P3{x * scale, y * scale, z * scale} + offset; };
    const auto add = [&](const Shape& shape, const ups_material_desc& m) { scene.add(shape.scaled(scale), m, offset); };
    ups_material_desc tinted = glass(1.5);
    for (int i = 0; i < 3; ++i) tinted.absorption_per_m_rgb[i] = float((0.25 + 0.5 * i) / scale);
    add(box({0, 0, 0}, {4, 3, 2.5}).flipped(), matte(0.6));
    add(box({2.5, 1.5, 0.25}, {3.5, 2.5, 1}), rough(UPS_MATERIAL_PLASTIC, 0.5, 0.3));
    add(icosphere({1, 1, 0.75}, 0.5, 2), tinted);
    if (lights != Lights::candela) add(quad({1.5, 1, 2.25}, {0, 1, 0}, {1, 0, 0}), emitter(500));
    const double intensity = lights == Lights::mixed ? 50 * scale * scale : 50;
    if (lights != Lights::area) scene.add_point_light(at(3, 1, 2), intensity);
    if (lights == Lights::candela) scene.add_spot(at(2, 2, 2.25), {0, -1, -1}, 2 * intensity, 0.25, 0.5);
    std::vector<P3> positions;
    for (int i = 0; i < 9; ++i) positions.push_back(at(0.5 + i % 3 * 1.25, 0.5 + i / 3 * 0.75, i % 2 ? 0.0 : 1.5));
    points = scene.add_meters(positions, {0, 0, 1});
    cells = scene.add_cells({at(2, 0.5, 0), at(0.5, 2, 0)}, {{0, 0, 1}, {0, 0, 1}}, {{1, 0, 0}, {1, 0, 0}}, 0.5 * scale,
                            0.5 * scale);
    if (with_camera) camera = scene.add_camera(at(0.25, 0.25, 1.75), {1, 0.75, -0.25}, 24, 16, 1.2);
  }
};

inline constexpr ups_method every_method[] = {UPS_METHOD_AUTO,         UPS_METHOD_UPS,
                                              UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING,
                                              UPS_METHOD_LIGHT_TRACING, UPS_METHOD_PPM,
                                              UPS_METHOD_SPPM,          UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING};
inline std::string name_of_method(const ::testing::TestParamInfo<ups_method>& info) {
  return info.param == UPS_METHOD_AUTO ? "auto" : method_name(info.param);
}

}  // namespace ups::test
