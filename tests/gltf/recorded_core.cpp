// See recorded_core.h. Defaults are those of the library where a test looks at them; profiles keep the bytes they were
// parsed from.
#include "recorded_core.h"

struct ups_profile {
  std::string bytes;
};

namespace {

std::string last_error;
int profiles = 0, fixtures_made = 0, fixtures = 0;

template <class Desc>
void write_defaults(Desc* desc, uint32_t size, Desc defaults) {
  defaults.struct_size = size;
  *desc = defaults;
}

template <class T>
std::vector<T> copied(const T* from, size_t count) {
  return from ? std::vector<T>(from, from + count) : std::vector<T>();
}

template <class Item, class Id>
ups_status record(std::vector<Item>& to, Item item, Id* out) {
  to.push_back(std::move(item));
  out->v = uint32_t(to.size());
  return UPS_OK;
}

}  // namespace

int made_fixtures() { return fixtures_made; }
int living_fixtures() { return fixtures; }
int living_profiles() { return profiles; }

const char* ups_last_error(void) { return last_error.c_str(); }

// The defaults of the real core, as far as the importer leaves fields at them.
void ups_texture_desc_init(ups_texture_desc* desc, uint32_t size) { write_defaults(desc, size, {}); }
void ups_mesh_desc_init(ups_mesh_desc* desc, uint32_t size) { write_defaults(desc, size, {}); }
void ups_instance_desc_init(ups_instance_desc* desc, uint32_t size) { write_defaults(desc, size, {}); }
void ups_light_desc_init(ups_light_desc* desc, uint32_t size) { write_defaults(desc, size, {}); }
void ups_camera_desc_init(ups_camera_desc* desc, uint32_t size) { write_defaults(desc, size, {}); }
void ups_observer_desc_init(ups_observer_desc* desc, uint32_t size) { write_defaults(desc, size, {}); }
void ups_goniometer_desc_init(ups_goniometer_desc* desc, uint32_t size) { write_defaults(desc, size, {}); }
void ups_meter_desc_init(ups_meter_desc* desc, uint32_t size) { write_defaults(desc, size, {}); }

void ups_material_desc_init(ups_material_desc* desc, uint32_t size) {
  ups_material_desc defaults{};
  for (int i = 0; i < 3; ++i) {
    defaults.reflectance_rgb[i] = 0.5f;
    defaults.transmittance_rgb[i] = -1;
    defaults.ior_rgb[i] = 1;
  }
  defaults.ior = 1.5f;
  defaults.alpha = 1;
  defaults.alpha_cutoff = 0.5f;
  defaults.normal_scale = 1;
  write_defaults(desc, size, defaults);
}

void ups_luminaire_desc_init(ups_luminaire_desc* desc, uint32_t size) {
  ups_luminaire_desc defaults{};
  defaults.use_opening = 1;
  for (float& c : defaults.color_rgb) c = 1;
  defaults.flux_lm = -1;
  defaults.dimming = defaults.intensity_scale = 1;
  write_defaults(desc, size, defaults);
}

ups_status ups_scene_add_texture(ups_scene* scene, const ups_texture_desc* d, ups_texture_id* out) {
  const size_t count = size_t(d->width) * d->height * d->channel_count;
  return record(scene->textures, {d->width, d->height, d->channel_count, copied(d->texels, count)}, out);
}

ups_status ups_scene_add_material(ups_scene* scene, const ups_material_desc* d, ups_material_id* out) {
  return record(scene->materials, *d, out);
}

ups_status ups_scene_add_mesh(ups_scene* scene, const ups_mesh_desc* d, ups_mesh_id* out) {
  const size_t count = d->vertex_count;
  return record(
      scene->meshes,
      {d->material.v, copied(d->positions_m, 3 * count), copied(d->normals, 3 * count), copied(d->uvs, 2 * count),
       copied(d->tangents, 4 * count), copied(d->indices, 3 * size_t(d->triangle_count))},
      out);
}

ups_status ups_scene_add_instance(ups_scene* scene, const ups_instance_desc* d, ups_instance_id* out) {
  return record(scene->instances, *d, out);
}

ups_status ups_scene_add_light(ups_scene* scene, const ups_light_desc* d, ups_luminaire_id* out) {
  return record(scene->lights, *d, out);
}

ups_status ups_scene_set_maintenance_factor(ups_scene* scene, double factor) {
  if (!(factor > 0)) {
    last_error = "recorded core: maintenance_factor is not above 0";
    return UPS_ERROR_INVALID_ARGUMENT;
  }
  scene->maintenance_factor = factor;
  return UPS_OK;
}

ups_status ups_scene_add_luminaire(ups_scene* scene, const ups_luminaire_desc* d, ups_luminaire_id* out) {
  return record(scene->luminaires, {*d, d->profile->bytes}, out);
}

ups_status ups_scene_add_camera(ups_scene* scene, const ups_camera_desc* d, ups_sensor_id* out) {
  return record(scene->cameras, *d, out);
}

ups_status ups_scene_add_meters(ups_scene* scene, const ups_meter_desc* d, ups_sensor_id* out) {
  if (d->kind != UPS_METER_PLANAR) {
    last_error = "recorded core: this kind of meter is not built";
    return UPS_ERROR_UNSUPPORTED;
  }
  const size_t count = d->count;
  return record(scene->meters,
                {d->kind,
                 copied(d->positions_m, 3 * count),
                 copied(d->normals, 3 * count),
                 copied(d->tangents, 3 * count),
                 {d->cell_size_m[0], d->cell_size_m[1]}},
                out);
}

ups_status ups_scene_add_observer(ups_scene* scene, const ups_observer_desc* d, ups_sensor_id* out) {
  return record(scene->observers, *d, out);
}

ups_status ups_scene_add_goniometer(ups_scene* scene, const ups_goniometer_desc* d, ups_sensor_id* out) {
  return record(scene->goniometers, {*d, copied(d->c_deg, d->c_count), copied(d->gamma_deg, d->gamma_count)}, out);
}

void ups_profile_parse_desc_init(ups_profile_parse_desc* d, uint32_t) {
  *d = {};
  d->tilt_deg = -1;
}

// What it was told: bytes, then "+" and the TILT file, "@" and the tilt, "#" and the lamp set.
ups_status ups_profile_parse_with(ups_context*, const ups_profile_parse_desc* d, ups_profile** out) {
  std::string text(static_cast<const char*>(d->bytes), d->size);
  if (text.rfind(refused_profile, 0) == 0) {
    last_error = "recorded core: no such format";
    return UPS_ERROR_UNSUPPORTED;
  }
  if (d->tilt_file) text.append("+").append(static_cast<const char*>(d->tilt_file), d->tilt_file_size);
  if (d->tilt_deg >= 0) text.append("@").append(std::to_string(int(d->tilt_deg)));
  if (d->lamp_set > 0) text.append("#").append(std::to_string(d->lamp_set));
  *out = new ups_profile{std::move(text)};
  ++profiles;
  return UPS_OK;
}

// Every profile has one warning. Bytes "TILT=name" name a TILT file.
ups_status ups_profile_get_text(const ups_profile* profile, ups_profile_text topic, char* text, size_t capacity,
                                size_t* needed) {
  std::string answer = "recorded warning\n";
  if (topic == UPS_PROFILE_TEXT_TILT_FILE)
    answer = profile->bytes.rfind("TILT=", 0) == 0 ? profile->bytes.substr(5, profile->bytes.find('@') - 5) : "";
  *needed = answer.size() + 1;
  if (text && capacity >= *needed) answer.copy(text, answer.size());
  if (text && capacity >= *needed) text[answer.size()] = '\0';
  return UPS_OK;
}

void ups_profile_destroy(ups_profile* profile) {
  if (profile) --profiles;
  delete profile;
}

// ---- fixtures

namespace {

// The core's defaults as far as the importer leaves fields at them: to_fixture is always written.
template <class Desc>
void custom_of(ups_fixture* fixture, const Desc* d) {
  if (d->finish == UPS_FINISH_CUSTOM) fixture->custom.push_back(*d->material);
}

}  // namespace

void ups_fixture_emitter_desc_init(ups_fixture_emitter_desc* desc, uint32_t size) {
  ups_fixture_emitter_desc defaults{};
  for (float& c : defaults.color_rgb) c = 1;
  write_defaults(desc, size, defaults);
}
void ups_reflector_desc_init(ups_reflector_desc* desc, uint32_t size) {
  ups_reflector_desc defaults{};
  defaults.smooth = 1;
  defaults.finish_reflectance = defaults.finish_transmittance = defaults.finish_roughness = -1;
  write_defaults(desc, size, defaults);
}
void ups_lens_desc_init(ups_lens_desc* desc, uint32_t size) {
  ups_lens_desc defaults{};
  defaults.finish = UPS_FINISH_PMMA;
  defaults.finish_roughness = defaults.finish_absorption_per_m = defaults.finish_ior = -1;
  write_defaults(desc, size, defaults);
}
void ups_collimator_desc_init(ups_collimator_desc* desc, uint32_t size) {
  ups_collimator_desc defaults{};
  defaults.smooth = 1;
  defaults.finish = UPS_FINISH_PMMA;
  defaults.finish_roughness = defaults.finish_absorption_per_m = defaults.finish_ior = -1;
  write_defaults(desc, size, defaults);
}
void ups_fixture_instance_desc_init(ups_fixture_instance_desc* desc, uint32_t size) {
  ups_fixture_instance_desc defaults{};
  defaults.dimming = 1;
  defaults.flux_lm = -1;
  write_defaults(desc, size, defaults);
}

ups_status ups_fixture_create(ups_context*, ups_fixture** out) {
  *out = new ups_fixture;
  ++fixtures_made;
  ++fixtures;
  return UPS_OK;
}

void ups_fixture_destroy(ups_fixture* fixture) {
  if (fixture) --fixtures;
  delete fixture;
}

ups_status ups_fixture_add_emitter(ups_fixture* f, const ups_fixture_emitter_desc* d, ups_fixture_part_id*) {
  f->parts.push_back("emitter");
  f->emitters.push_back(*d);
  return UPS_OK;
}

ups_status ups_fixture_add_reflector(ups_fixture* f, const ups_reflector_desc* d, ups_fixture_part_id*) {
  if (d->aperture_radius_m < 0) {
    last_error = "recorded core: aperture_radius_m is less than 0";
    return UPS_ERROR_INVALID_ARGUMENT;
  }
  f->parts.push_back("reflector");
  f->reflectors.push_back(*d);
  f->points = copied(d->profile_rz_m, 2 * size_t(d->profile_point_count));
  custom_of(f, d);
  return UPS_OK;
}

ups_status ups_fixture_add_lens(ups_fixture* f, const ups_lens_desc* d, ups_fixture_part_id*) {
  f->parts.push_back("lens");
  f->lenses.push_back(*d);
  custom_of(f, d);
  return UPS_OK;
}

ups_status ups_fixture_add_collimator(ups_fixture* f, const ups_collimator_desc* d, ups_fixture_part_id*) {
  f->parts.push_back("collimator");
  f->collimators.push_back(*d);
  f->points = copied(d->wall_rz_m, 2 * size_t(d->wall_point_count));
  custom_of(f, d);
  return UPS_OK;
}

ups_status ups_scene_add_fixture(ups_scene* scene, const ups_fixture* fixture, const ups_fixture_instance_desc* d,
                                 ups_fixture_id* out) {
  return record(scene->fixtures, {*d, *fixture}, out);
}

ups_status ups_scene_get_fixture_instance(const ups_scene*, ups_fixture_id id, ups_fixture_part_id part,
                                          ups_instance_id* out) {
  *out = {recorded_part_instance(id.v, part.v)};
  return UPS_OK;
}
