// A committed room that a test may poison: the API lets no such scene in. For tests of the inner layers.
#pragma once
#include <algorithm>
#include <memory>

#include "scene/prepare.h"

namespace ups::test {

// A room of one material, outwards, with a lamp, two meters and a camera; open: one wall is missing.
inline std::shared_ptr<Snapshot> room(ups_material_model model, bool open = false) {
  Description description;
  ups_material_desc material{};
  material.struct_size = sizeof material;
  material.model = model;
  for (int i = 0; i < 3; ++i) material.reflectance_rgb[i] = 0.5f, material.transmittance_rgb[i] = -1;
  material.ior = 1.5f, material.alpha = 1, material.alpha_cutoff = 0.5f, material.normal_scale = 1;
  static const float p[24] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 4, 4, 0, 0, 0, 3, 4, 0, 3, 0, 4, 3, 4, 4, 3};
  static const uint32_t i[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  ups_mesh_desc mesh{};
  mesh.vertex_count = 8, mesh.triangle_count = open ? 10 : 12;
  mesh.material = description.add_material(material);
  mesh.positions_m = p, mesh.indices = i;
  ups_instance_desc instance{};
  instance.mesh = description.add_mesh(mesh);
  const auto place = [](double (&m)[12], double x, double y, double z) {
    const double at[12] = {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z};
    std::copy(std::begin(at), std::end(at), m);
  };
  place(instance.to_world, 0, 0, 0);
  description.add_instance(instance);
  ups_light_desc light{};
  place(light.to_world, 2, 2, 2);
  for (float& v : light.intensity_rgb) v = 100;
  description.add_light(light);
  ups_camera_desc camera{};
  camera.width = camera.height = 4;
  camera.vertical_fov_rad = 1;
  place(camera.to_world, 1, 1, 2.5);
  description.add_camera(camera);
  const double positions[6] = {1, 1, 1, 3, 2, 1};
  const float normals[6] = {0, 0, 1, 0, 0, 1};
  ups_meter_desc meters{};
  meters.count = 2;
  meters.positions_m = positions, meters.normals = normals;
  description.add_meters(meters);
  ThreadPool pool(2);
  return std::const_pointer_cast<Snapshot>(prepare(description, pool));
}

}  // namespace ups::test
