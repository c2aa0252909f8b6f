// Scenes in a few lines, for tests that go through the public C API alone. Every failing call throws with the library's
// message; what a render gives back is checked by Result (result.h).
//
//   Scene scene;
//   scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.5));
//   scene.add_point_light({2, 2, 2.5}, 100);
//   const auto meters = scene.add_meters({{1, 1, 0}}, {0, 0, 1});
//   const Result result = scene.render({.method = UPS_METHOD_UPS, .iterations = 64});
//   result.readings(meters)[0].illuminance_lx
#pragma once
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "effort.h"
#include "render_trace.h"
#include "result.h"
#include "shapes.h"
#include "ups/ups.h"

namespace ups::test {

template <class Desc, class Init>
Desc make_desc(Init init) {
  Desc d;
  init(&d, uint32_t(sizeof d));
  return d;
}

// ---- materials ------------------------------------------------------------------------------------------------------

inline ups_material_desc material(ups_material_model model, double reflectance) {
  auto d = make_desc<ups_material_desc>(ups_material_desc_init);
  d.model = model;
  for (float& r : d.reflectance_rgb) r = float(reflectance);
  return d;
}
inline ups_material_desc matte(double reflectance) { return material(UPS_MATERIAL_MATTE, reflectance); }
inline ups_material_desc mirror(double reflectance) { return material(UPS_MATERIAL_MIRROR, reflectance); }
// A mask without holes: such a mirror shows no lamp as its image, so that photons carry the light that it reflects.
inline ups_material_desc photon_mirror(double reflectance) {
  auto d = mirror(reflectance);
  d.alpha_mode = UPS_ALPHA_MASK;
  return d;
}
inline ups_material_desc glass(double ior, double roughness = 0) {
  auto d = material(UPS_MATERIAL_GLASS, 1);
  d.ior = float(ior);
  d.roughness = float(roughness);
  return d;
}
inline ups_material_desc rough(ups_material_model model, double reflectance, double roughness) {
  auto d = material(model, reflectance);
  d.roughness = float(roughness);
  return d;
}
// Matte, and its front has a luminance of its own.
inline ups_material_desc emitter(double luminance_cd_m2, double reflectance = 0) {
  auto d = matte(reflectance);
  for (float& l : d.luminance_cd_m2) l = float(luminance_cd_m2);
  return d;
}

// ---- scene ----------------------------------------------------------------------------------------------------------

// 1000, 700 and 0 cd at gamma 0, 45 and 90 degrees, all around. opening_m: side of a square; 0: a point.
inline std::unique_ptr<ups_profile, decltype(&ups_profile_destroy)> table_profile(ups_context* context,
                                                                                  float opening_m) {
  const float gamma[3] = {0, 45, 90}, c = 0, intensity[3] = {1000, 700, 0};
  auto d = make_desc<ups_profile_desc>(ups_profile_desc_init);
  d.c_count = 1;
  d.gamma_count = 3;
  d.c_deg = &c;
  d.gamma_deg = gamma;
  d.intensity_cd = intensity;
  if (opening_m > 0) {
    d.opening_shape = UPS_OPENING_RECTANGLE;
    d.opening_m[0] = d.opening_m[1] = opening_m;
  }
  ups_profile* profile = nullptr;
  check(ups_profile_create(context, &d, &profile), "ups_profile_create");
  return {profile, ups_profile_destroy};
}

struct RenderOptions {
  ups_method method = UPS_METHOD_UPS;
  uint32_t iterations = 64;
  uint64_t seed = 1;
  double merge_radius_m = 0;
  uint32_t light_paths = 0;
  uint32_t techniques = 0;
  uint32_t max_path_length = 0;
  ups_perturbation perturbation = UPS_PERTURBATION_VIRTUAL;
  uint32_t technique_images = 0;
  double radius_alpha = 0;
  double glossy_alpha = 0;
  ups_separation separation = UPS_SEPARATE_NOTHING;
  uint64_t flux_paths = 0;
  double target_relative_error = 0;
};

// Local -Z along `direction`, at `position`; row-major 3x4.
inline std::array<double, 12> facing(const P3& position, const P3& direction) {
  const P3 z = normalize(direction) * -1,
           x = normalize(std::abs(z.z) < 0.9 ? cross({0, 0, 1}, z) : cross({0, 1, 0}, z));
  const P3 y = cross(z, x);
  return {x.x, y.x, z.x, position.x, x.y, y.y, z.y, position.y, x.z, y.z, z.z, position.z};
}

class Scene {
 public:
  explicit Scene(int threads = 0) {
    auto d = make_desc<ups_context_desc>(ups_context_desc_init);
    d.thread_count = threads;
    ups_context* context = nullptr;
    check(ups_context_create(&d, &context), "ups_context_create");
    context_.reset(context);
    ups_scene* scene = nullptr;
    check(ups_scene_create(context, &scene), "ups_scene_create");
    scene_.reset(scene);
  }
  ups_context* context() const { return context_.get(); }
  ups_scene* get() const { return scene_.get(); }

  // Of everything that emits and is added from here on.
  void set_group(uint32_t group) { group_ = group; }
  // Of all meters that are added from here on.
  void set_meter_kind(ups_meter_kind kind) { meter_kind_ = kind; }

  // `offset` moves the instance, in double: far from the origin floats could not hold the vertices.
  ups_instance_id add(const Shape& shape, const ups_material_desc& material, const P3& offset = {}) {
    ups_material_id material_id;
    check(ups_scene_add_material(scene_.get(), &material, &material_id), "ups_scene_add_material");
    std::vector<float> positions;
    for (const P3& v : shape.vertices) positions.insert(positions.end(), {float(v.x), float(v.y), float(v.z)});
    auto mesh = make_desc<ups_mesh_desc>(ups_mesh_desc_init);
    mesh.vertex_count = uint32_t(shape.vertices.size());
    mesh.triangle_count = uint32_t(shape.triangles.size());
    mesh.material = material_id;
    mesh.positions_m = positions.data();
    mesh.indices = shape.triangles.data()->data();
    std::vector<float> normals;
    for (const P3& n : shape.normals) normals.insert(normals.end(), {float(n.x), float(n.y), float(n.z)});
    if (!normals.empty()) mesh.normals = normals.data();
    if (!shape.uvs.empty()) mesh.uvs = shape.uvs.data()->data();
    auto instance = make_desc<ups_instance_desc>(ups_instance_desc_init);
    check(ups_scene_add_mesh(scene_.get(), &mesh, &instance.mesh), "ups_scene_add_mesh");
    instance.group = group_;
    instance.to_world[3] = offset.x;
    instance.to_world[7] = offset.y;
    instance.to_world[11] = offset.z;
    ups_instance_id id;
    check(ups_scene_add_instance(scene_.get(), &instance, &id), "ups_scene_add_instance");
    return id;
  }

  // 3 channels, row 0 first.
  ups_texture_id add_texture(uint32_t width, uint32_t height, const std::vector<float>& texels) {
    auto d = make_desc<ups_texture_desc>(ups_texture_desc_init);
    d.width = width;
    d.height = height;
    d.channel_count = 3;
    d.texels = texels.data();
    ups_texture_id id;
    check(ups_scene_add_texture(scene_.get(), &d, &id), "ups_scene_add_texture");
    return id;
  }

  void add_point_light(const P3& position, double intensity_cd) {
    add_light(UPS_LIGHT_POINT, position, {0, 0, -1}, intensity_cd, 0, pi_d / 4);
  }
  void add_spot(const P3& position, const P3& direction, double intensity_cd, double inner_rad, double outer_rad) {
    add_light(UPS_LIGHT_SPOT, position, direction, intensity_cd, inner_rad, outer_rad);
  }
  void add_directional(const P3& direction, double illuminance_lx) {
    add_light(UPS_LIGHT_DIRECTIONAL, {0, 0, 0}, direction, illuminance_lx, 0, pi_d / 4);
  }
  // Nadir along `direction`.
  void add_luminaire(const ups_profile* profile, const P3& position, const P3& direction, bool opening) {
    auto d = make_desc<ups_luminaire_desc>(ups_luminaire_desc_init);
    d.profile = profile;
    d.use_opening = opening;
    d.group = group_;
    const auto m = facing(position, direction);
    std::copy(m.begin(), m.end(), d.to_world);
    ups_luminaire_id id;
    check(ups_scene_add_luminaire(scene_.get(), &d, &id), "ups_scene_add_luminaire");
  }

  Sensor add_meters(const std::vector<P3>& positions, const P3& normal) {
    return add_meters(positions, std::vector<P3>(positions.size(), normal));
  }
  Sensor add_meters(const std::vector<P3>& positions, const std::vector<P3>& normals) {
    return add_meter_set(positions, normals, {}, 0, 0);
  }
  // Rectangles of the same size, each from its centre; `tangents` run along the width.
  Sensor add_cells(const std::vector<P3>& centers, const std::vector<P3>& normals, const std::vector<P3>& tangents,
                   double width, double height) {
    return add_meter_set(centers, normals, tangents, width, height);
  }
  // Each the mean over a disc about a point.
  Sensor add_discs(const std::vector<P3>& centers, const std::vector<P3>& normals, double diameter) {
    return add_meter_set(centers, normals, {}, 0, 0, diameter);
  }
  Sensor add_surface_meters(const std::vector<ups_instance_id>& instances, uint32_t triangles, bool back = false) {
    auto d = make_desc<ups_surface_meters_desc>(ups_surface_meters_desc_init);
    d.instances = instances.data();
    d.instance_count = uint32_t(instances.size());
    d.back = back;
    Sensor s{{0}, triangles};
    check(ups_scene_add_surface_meters(scene_.get(), &d, &s.id), "ups_scene_add_surface_meters");
    sensors_.push_back(s);
    return s;
  }
  Sensor add_lightmap(const std::vector<ups_instance_id>& instances, uint32_t width, uint32_t height) {
    auto d = make_desc<ups_lightmap_desc>(ups_lightmap_desc_init);
    d.instances = instances.data();
    d.instance_count = uint32_t(instances.size());
    d.width = width;
    d.height = height;
    Sensor s{{0}, width * height};
    check(ups_scene_add_lightmap(scene_.get(), &d, &s.id), "ups_scene_add_lightmap");
    sensors_.push_back(s);
    return s;
  }
  // Of the scene as it was committed last.
  std::vector<ups_meter_place> places(const Sensor& meters) const {
    std::vector<ups_meter_place> out(meters.count);
    check(ups_scene_read_meter_places(scene_.get(), meters.id, out.data(), out.size(), nullptr),
          "ups_scene_read_meter_places");
    return out;
  }
  Sensor add_camera(const P3& position, const P3& direction, uint32_t width, uint32_t height, double vertical_fov_rad,
                    bool illuminance = false, ups_projection projection = UPS_PERSPECTIVE, uint32_t layers = 0) {
    auto d = make_desc<ups_camera_desc>(ups_camera_desc_init);
    d.width = width;
    d.height = height;
    d.vertical_fov_rad = float(vertical_fov_rad);
    const auto m = facing(position, direction);
    std::copy(m.begin(), m.end(), d.to_world);
    d.illuminance = illuminance;
    d.projection = projection;
    d.layers = layers;
    Sensor s{{0}, 0, width, height, illuminance};
    check(ups_scene_add_camera(scene_.get(), &d, &s.id), "ups_scene_add_camera");
    sensors_.push_back(s);
    return s;
  }

  // An eye, the world's up above it; its meter is among the sensors.
  Sensor add_observer(const P3& position, const P3& direction,
                      ups_position_index index = UPS_POSITION_INDEX_TABLE, float ceiling_area_m2 = 0) {
    auto d = make_desc<ups_observer_desc>(ups_observer_desc_init);
    d.position_index = index;
    d.ceiling_area_m2 = ceiling_area_m2;
    const auto m = facing(position, direction);
    std::copy(m.begin(), m.end(), d.to_world);
    Sensor s{{0}, 1, 0, 0};
    check(ups_scene_add_observer(scene_.get(), &d, &s.id), "ups_scene_add_observer");
    sensors_.push_back(s);
    return s;
  }

  // Axes along the world's, nadir down.
  Sensor add_goniometer(uint32_t planes, uint32_t gammas, ups_profile_symmetry symmetry = UPS_SYMMETRY_NONE) {
    auto d = make_desc<ups_goniometer_desc>(ups_goniometer_desc_init);
    d.c_count = planes;
    d.gamma_count = gammas;
    d.symmetry = symmetry;
    Sensor s;
    s.planes = planes;
    s.gammas = gammas;
    check(ups_scene_add_goniometer(scene_.get(), &d, &s.id), "ups_scene_add_goniometer");
    sensors_.push_back(s);
    return s;
  }

  static ups_render_desc desc_of(const RenderOptions& options) {
    auto d = make_desc<ups_render_desc>(ups_render_desc_init);
    d.method = options.method;
    d.iteration_count = with_effort(options.iterations);
    d.seed = options.seed;
    d.merge_radius_m = float(options.merge_radius_m);
    d.light_paths_per_iteration = paths_with_effort(options.light_paths);
    d.techniques = options.techniques;
    d.max_path_length = options.max_path_length;
    d.perturbation = options.perturbation;
    d.technique_images = options.technique_images;
    d.radius_alpha = float(options.radius_alpha);
    d.glossy_alpha = float(options.glossy_alpha);
    d.separation = options.separation;
    d.flux_paths = options.flux_paths;
    d.target_relative_error = float(options.target_relative_error);
    return d;
  }
  Result render(const RenderOptions& options) {
    check(ups_scene_commit(scene_.get()), "ups_scene_commit");
    const ups_render_desc d = desc_of(options);
    ups_result* result = nullptr;
    const std::clock_t began = std::clock();
    check(ups_render(scene_.get(), &d, &result), "ups_render");
    Result rendered(result, sensors_);
    if (traces_renders())
      trace_render("method " + std::to_string(options.method) + ", " + std::to_string(d.iteration_count) +
                   " iterations, " + std::to_string(options.light_paths) + " light paths", began, rendered, sensors_);
    return rendered;
  }

 private:
  void add_light(ups_light_kind kind, const P3& position, const P3& direction, double intensity, double inner,
                 double outer) {
    auto d = make_desc<ups_light_desc>(ups_light_desc_init);
    d.kind = kind;
    const auto m = facing(position, direction);
    std::copy(m.begin(), m.end(), d.to_world);
    for (float& i : d.intensity_rgb) i = float(intensity);
    d.group = group_;
    d.inner_cone_rad = float(inner);
    d.outer_cone_rad = float(outer);
    ups_luminaire_id id;
    check(ups_scene_add_light(scene_.get(), &d, &id), "ups_scene_add_light");
  }
  Sensor add_meter_set(const std::vector<P3>& positions, const std::vector<P3>& normals,
                       const std::vector<P3>& tangents, double width, double height, double footprint = 0) {
    std::vector<double> p;
    std::vector<float> n, t;
    for (const P3& v : positions) p.insert(p.end(), {v.x, v.y, v.z});
    for (const P3& v : normals) n.insert(n.end(), {float(v.x), float(v.y), float(v.z)});
    for (const P3& v : tangents) t.insert(t.end(), {float(v.x), float(v.y), float(v.z)});
    auto d = make_desc<ups_meter_desc>(ups_meter_desc_init);
    d.kind = meter_kind_;
    d.count = uint32_t(positions.size());
    d.positions_m = p.data();
    d.normals = n.data();
    d.tangents = t.empty() ? nullptr : t.data();
    d.cell_size_m[0] = float(width);
    d.cell_size_m[1] = float(height);
    d.footprint_m = float(footprint);
    Sensor s{{0}, d.count, 0, 0};
    check(ups_scene_add_meters(scene_.get(), &d, &s.id), "ups_scene_add_meters");
    sensors_.push_back(s);
    return s;
  }

  std::unique_ptr<ups_context, decltype(&ups_context_destroy)> context_{nullptr, ups_context_destroy};
  std::unique_ptr<ups_scene, decltype(&ups_scene_destroy)> scene_{nullptr, ups_scene_destroy};
  std::vector<Sensor> sensors_;
  uint32_t group_ = 0;
  ups_meter_kind meter_kind_ = UPS_METER_PLANAR;
};

}  // namespace ups::test
