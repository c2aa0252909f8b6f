// ups_scene.h, ups_sensor.h, ups_glare.h: what was added to a scene is set, asked for and removed.
#include "api/desc.h"
#include "api/handles.h"
#include "scene/check.h"

using namespace ups;
using namespace ups::api;

namespace {

template <class Change>
ups_status change(const char* function, ups_scene* scene, const Change& body) {
  return guard(function, [&] { body(require(scene, "scene").description); });
}

// set: member of Description that takes an id and a whole desc.
template <class Id, class Desc>
ups_status set(const char* function, ups_scene* scene, Id id, const Desc* desc, void (*init)(Desc*, uint32_t),
               void (Description::*set_in)(Id, const Desc&)) {
  return change(function, scene, [&](Description& d) { (d.*set_in)(id, read_desc(desc, init)); });
}

// get_from: member of Description that gives the desc of an id.
template <class Id, class Desc>
ups_status get(const char* function, const ups_scene* scene, Id id, Desc* desc,
               Desc (Description::*get_from)(Id) const) {
  return guard(function,
               [&] { write_info(desc, (require(scene, "scene").description.*get_from)(id), "desc"); });
}

template <class Id>
ups_status set_transform(const char* function, ups_scene* scene, Id id, const double* to_world,
                         void (Description::*set_in)(Id, const double (&)[12])) {
  return change(function, scene, [&](Description& d) {
    check::pointer(to_world, "to_world");
    double copy[12];
    std::copy(to_world, to_world + 12, copy);
    (d.*set_in)(id, copy);
  });
}

}  // namespace

// ---- set ----

ups_status ups_scene_set_texture(ups_scene* scene, ups_texture_id id, const ups_texture_desc* desc) {
  return set(__func__, scene, id, desc, &ups_texture_desc_init, &Description::set_texture);
}

ups_status ups_scene_set_material(ups_scene* scene, ups_material_id id, const ups_material_desc* desc) {
  return set(__func__, scene, id, desc, &ups_material_desc_init, &Description::set_material);
}

ups_status ups_scene_set_mesh(ups_scene* scene, ups_mesh_id id, const ups_mesh_desc* desc) {
  return set(__func__, scene, id, desc, &ups_mesh_desc_init, &Description::set_mesh);
}

ups_status ups_scene_set_mesh_vertices(ups_scene* scene, ups_mesh_id id, const float* positions_m, const float* normals,
                                       uint32_t vertex_count) {
  return change(__func__, scene,
                [&](Description& d) { d.set_mesh_vertices(id, positions_m, normals, vertex_count); });
}

ups_status ups_scene_set_instance(ups_scene* scene, ups_instance_id id, const ups_instance_desc* desc) {
  return change(__func__, scene, [&](Description& d) { d.set_instance(id, read_desc(desc, &ups_instance_desc_init)); });
}

ups_status ups_scene_set_transform(ups_scene* scene, ups_instance_id id, const double to_world[12]) {
  return set_transform(__func__, scene, id, to_world, &Description::set_transform);
}

ups_status ups_scene_set_light(ups_scene* scene, ups_luminaire_id id, const ups_light_desc* desc) {
  return set(__func__, scene, id, desc, &ups_light_desc_init, &Description::set_light);
}

ups_status ups_scene_set_luminaire(ups_scene* scene, ups_luminaire_id id, const ups_luminaire_desc* desc) {
  return change(__func__, scene, [&](Description& d) {
    const ups_luminaire_desc whole = read_desc(desc, &ups_luminaire_desc_init);
    d.set_luminaire(id, whole, whole.profile ? require(whole.profile, "profile").data : nullptr);
  });
}

ups_status ups_scene_set_luminaire_transform(ups_scene* scene, ups_luminaire_id id, const double to_world[12]) {
  return set_transform(__func__, scene, id, to_world, &Description::set_luminaire_transform);
}

ups_status ups_scene_set_dimming(ups_scene* scene, ups_luminaire_id id, float dimming) {
  return change(__func__, scene, [&](Description& d) { d.set_dimming(id, dimming); });
}

ups_status ups_scene_set_maintenance_factor(ups_scene* scene, double factor) {
  return change(__func__, scene, [&](Description& d) { d.set_maintenance_factor(factor); });
}

ups_status ups_scene_set_camera(ups_scene* scene, ups_sensor_id id, const ups_camera_desc* desc) {
  return set(__func__, scene, id, desc, &ups_camera_desc_init, &Description::set_camera);
}

ups_status ups_scene_set_meters(ups_scene* scene, ups_sensor_id id, const ups_meter_desc* desc) {
  return set(__func__, scene, id, desc, &ups_meter_desc_init, &Description::set_meters);
}

ups_status ups_scene_set_surface_meters(ups_scene* scene, ups_sensor_id id, const ups_surface_meters_desc* desc) {
  return set(__func__, scene, id, desc, &ups_surface_meters_desc_init, &Description::set_surface_meters);
}

ups_status ups_scene_set_lightmap(ups_scene* scene, ups_sensor_id id, const ups_lightmap_desc* desc) {
  return set(__func__, scene, id, desc, &ups_lightmap_desc_init, &Description::set_lightmap);
}

ups_status ups_scene_set_goniometer(ups_scene* scene, ups_sensor_id id, const ups_goniometer_desc* desc) {
  return set(__func__, scene, id, desc, &ups_goniometer_desc_init, &Description::set_goniometer);
}

ups_status ups_scene_set_observer(ups_scene* scene, ups_sensor_id id, const ups_observer_desc* desc) {
  return set(__func__, scene, id, desc, &ups_observer_desc_init, &Description::set_observer);
}

// ---- get ----

ups_status ups_scene_get_texture(const ups_scene* scene, ups_texture_id id, ups_texture_desc* desc) {
  return get(__func__, scene, id, desc, &Description::texture);
}

ups_status ups_scene_read_texture(const ups_scene* scene, ups_texture_id id, float* texels, size_t capacity,
                                  size_t* needed) {
  return guard(__func__, [&] {
    const Texture& texture = *require(scene, "scene").description.textures().get(id.v, "texture").texture;
    copy_array(texture.texel_count(), texels, capacity, needed, "texels", [&](size_t i) { return texture.texel(i); });
  });
}

ups_status ups_scene_get_material(const ups_scene* scene, ups_material_id id, ups_material_desc* desc) {
  return get(__func__, scene, id, desc, &Description::material);
}

ups_status ups_scene_get_mesh(const ups_scene* scene, ups_mesh_id id, ups_mesh_desc* desc) {
  return get(__func__, scene, id, desc, &Description::mesh);
}

ups_status ups_scene_get_instance(const ups_scene* scene, ups_instance_id id, ups_instance_desc* desc) {
  return get(__func__, scene, id, desc, &Description::instance);
}

ups_status ups_scene_get_light(const ups_scene* scene, ups_luminaire_id id, ups_light_desc* desc) {
  return get(__func__, scene, id, desc, &Description::light);
}

ups_status ups_scene_get_luminaire(const ups_scene* scene, ups_luminaire_id id, ups_luminaire_desc* desc) {
  return get(__func__, scene, id, desc, &Description::luminaire);
}

ups_status ups_scene_get_luminaire_profile(const ups_scene* scene, ups_luminaire_id id, ups_profile** out) {
  return guard(__func__, [&] {
    const ups_scene& s = require(scene, "scene");
    require(out, "out");
    *out = new ups_profile{.data = s.description.profile(id)};
  });
}

ups_status ups_scene_get_dimming(const ups_scene* scene, ups_luminaire_id id, float* out) {
  return guard(__func__, [&] {
    const ups_scene& s = require(scene, "scene");
    require(out, "out") = s.description.dimming(id);
  });
}

ups_status ups_scene_get_maintenance_factor(const ups_scene* scene, double* out) {
  return guard(__func__, [&] {
    const ups_scene& s = require(scene, "scene");
    require(out, "out") = s.description.maintenance_factor();
  });
}

ups_status ups_scene_get_camera(const ups_scene* scene, ups_sensor_id id, ups_camera_desc* desc) {
  return get(__func__, scene, id, desc, &Description::camera);
}

ups_status ups_scene_get_meters(const ups_scene* scene, ups_sensor_id id, ups_meter_desc* desc) {
  return get(__func__, scene, id, desc, &Description::meters);
}

ups_status ups_scene_get_surface_meters(const ups_scene* scene, ups_sensor_id id, ups_surface_meters_desc* desc) {
  return get(__func__, scene, id, desc, &Description::surface_meters);
}

ups_status ups_scene_get_lightmap(const ups_scene* scene, ups_sensor_id id, ups_lightmap_desc* desc) {
  return get(__func__, scene, id, desc, &Description::lightmap);
}

ups_status ups_scene_get_goniometer(const ups_scene* scene, ups_sensor_id id, ups_goniometer_desc* desc) {
  return get(__func__, scene, id, desc, &Description::goniometer);
}

ups_status ups_scene_get_observer(const ups_scene* scene, ups_sensor_id id, ups_observer_desc* desc) {
  return get(__func__, scene, id, desc, &Description::observer);
}

// ---- remove ----

ups_status ups_scene_remove_texture(ups_scene* scene, ups_texture_id id) {
  return change(__func__, scene, [&](Description& d) { d.remove_texture(id); });
}

ups_status ups_scene_remove_material(ups_scene* scene, ups_material_id id) {
  return change(__func__, scene, [&](Description& d) { d.remove_material(id); });
}

ups_status ups_scene_remove_mesh(ups_scene* scene, ups_mesh_id id) {
  return change(__func__, scene, [&](Description& d) { d.remove_mesh(id); });
}

ups_status ups_scene_remove_instance(ups_scene* scene, ups_instance_id id) {
  return change(__func__, scene, [&](Description& d) { d.remove_instance(id); });
}

ups_status ups_scene_remove_luminaire(ups_scene* scene, ups_luminaire_id id) {
  return change(__func__, scene, [&](Description& d) { d.remove_luminaire(id); });
}

ups_status ups_scene_remove_sensor(ups_scene* scene, ups_sensor_id id) {
  return change(__func__, scene, [&](Description& d) { d.remove_sensor(id); });
}
