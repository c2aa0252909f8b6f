// A description in a few lines, for tests of what a commit builds.
#pragma once
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "scene/prepare.h"

namespace ups {

struct Things {
  Description description;

  static ups_material_desc desc(ups_material_model model, float luminance = 0, float absorption = 0) {
    ups_material_desc d{};
    d.struct_size = sizeof d;
    d.model = model;
    for (float& r : d.reflectance_rgb) r = 0.5f;
    for (float& t : d.transmittance_rgb) t = -1;
    for (float& l : d.luminance_cd_m2) l = luminance;
    for (float& a : d.absorption_per_m_rgb) a = absorption;
    d.ior = 1.5f, d.alpha = 1, d.alpha_cutoff = 0.5f, d.normal_scale = 1;
    return d;
  }
  uint32_t material(ups_material_model model, float luminance = 0, float absorption = 0) {
    return description.add_material(desc(model, luminance, absorption)).v;
  }
  // A box with its front outwards, placed.
  void box(uint32_t material, const Vec3d& lo, const Vec3d& hi, bool mirrored = false) {
    static const float p[24] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
    static const uint32_t i[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                   2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    ups_mesh_desc m{};
    m.vertex_count = 8, m.triangle_count = 12;
    m.material.v = material;
    m.positions_m = p, m.indices = i;
    ups_instance_desc d{};
    d.mesh = description.add_mesh(m);
    const Vec3d s = hi - lo;
    const double place[12] = {mirrored ? -s.x : s.x, 0, 0, mirrored ? hi.x : lo.x, 0, s.y, 0, lo.y, 0, 0, s.z, lo.z};
    std::copy(std::begin(place), std::end(place), d.to_world);
    description.add_instance(d);
  }
  // 4 x 4 m of so many squares along a side, its front up.
  void sheet(uint32_t material, uint32_t side, float z) {
    std::vector<float> p;
    std::vector<uint32_t> corners;
    for (uint32_t j = 0; j <= side; ++j)
      for (uint32_t i = 0; i <= side; ++i) {
        p.insert(p.end(), {4 * float(i) / float(side) - 2, 4 * float(j) / float(side) - 2, z});
        const uint32_t a = j * (side + 1) + i, b = a + side + 1;
        if (i < side && j < side) corners.insert(corners.end(), {a, a + 1, b + 1, a, b + 1, b});
      }
    ups_mesh_desc m{};
    m.vertex_count = uint32_t(p.size() / 3), m.triangle_count = uint32_t(corners.size() / 3);
    m.material.v = material;
    m.positions_m = p.data(), m.indices = corners.data();
    ups_instance_desc d{};
    d.mesh = description.add_mesh(m);
    d.to_world[0] = d.to_world[5] = d.to_world[10] = 1;
    description.add_instance(d);
  }
  void meter(const Vec3d& p, const Vec3& n) {
    const double position[3] = {p.x, p.y, p.z};
    const float normal[3] = {n.x, n.y, n.z};
    ups_meter_desc d{};
    d.count = 1;
    d.positions_m = position, d.normals = normal;
    description.add_meters(d);
  }
  void point_light(const Vec3d& p, float cd = 1) {
    ups_light_desc d{};
    const double place[12] = {1, 0, 0, p.x, 0, 1, 0, p.y, 0, 0, 1, p.z};
    std::copy(std::begin(place), std::end(place), d.to_world);
    for (float& i : d.intensity_rgb) i = cd;
    description.add_light(d);
  }
  // Below the nadir alone, 100 cd; a downlight with an opening or without.
  void downlight(const Vec3d& p, photometry::Opening opening, float flux_lm) {
    photometry::Photometry data{photometry::Distribution({0}, {0, 90}, {100, 0})};
    data.opening = opening;
    ups_luminaire_desc d{};
    d.use_opening = 1;
    const double place[12] = {2, 0, 0, p.x, 0, 2, 0, p.y, 0, 0, 2, p.z};  // its scale must not matter
    std::copy(std::begin(place), std::end(place), d.to_world);
    d.color_rgb[0] = 2, d.color_rgb[1] = d.color_rgb[2] = 1;
    d.flux_lm = flux_lm, d.dimming = 0.5f, d.intensity_scale = 0.8f;
    description.add_luminaire(d, std::make_shared<photometry::Photometry>(std::move(data)));
  }
  std::shared_ptr<const Snapshot> build() const {
    ThreadPool pool(2);
    return prepare(description, pool);
  }
};

}  // namespace ups
