// ups_fixture.h: defaults of the descs, parts of fixtures, and fixtures placed in scenes.
#include "api/desc.h"
#include "api/handles.h"
#include "scene/check.h"

using namespace ups;
using namespace ups::api;

namespace {

// A desc that another one points to, made whole in turn.
template <class Desc>
void complete(const Desc*& nested, Desc& whole, void (*init)(Desc*, uint32_t), const char* field) {
  if (nested) nested = &(whole = read_desc(nested, init, field));
}

// Adds what `desc` describes; errors say which part it would have been.
template <class Desc>
ups_status add(const char* function, ups_fixture* fixture, const Desc* desc, void (*init)(Desc*, uint32_t),
               const char* kind, ups_fixture_part_id* out) {
  return guard(function, [&] {
    auto& parts = require(fixture, "fixture").data.parts;
    Desc d = read_desc(desc, init);
    const std::string name = "part " + std::to_string(parts.size() + 1) + " (" + kind + "): ";
    try {
      ups_material_desc material;
      ups_mesh_desc mesh;
      if constexpr (requires { d.material; })
        if (d.finish == UPS_FINISH_CUSTOM) complete(d.material, material, &ups_material_desc_init, "material");
      if constexpr (requires { d.mesh; }) complete(d.mesh, mesh, &ups_mesh_desc_init, "mesh");
      parts.push_back(std::make_shared<const FixturePart>(make_part(d)));
    } catch (const Error& e) {
      throw Error(e.status(), name + e.what());
    } catch (const std::invalid_argument& e) {
      fail_argument(name + e.what());
    }
    if (out) out->v = uint32_t(parts.size());
  });
}

}  // namespace

// ---- defaults ----

void ups_fixture_emitter_desc_init(ups_fixture_emitter_desc* desc, uint32_t struct_size) {
  ups_fixture_emitter_desc d{};
  set_identity(d.to_fixture);
  for (float& c : d.color_rgb) c = 1;
  write_defaults(desc, struct_size, d);
}

void ups_reflector_desc_init(ups_reflector_desc* desc, uint32_t struct_size) {
  ups_reflector_desc d{};
  set_identity(d.to_fixture);
  d.smooth = 1;
  d.finish = UPS_FINISH_SPECULAR_ALUMINIUM;
  d.finish_reflectance = d.finish_transmittance = d.finish_roughness = -1;
  write_defaults(desc, struct_size, d);
}

void ups_lens_desc_init(ups_lens_desc* desc, uint32_t struct_size) {
  ups_lens_desc d{};
  set_identity(d.to_fixture);
  d.finish = UPS_FINISH_PMMA;
  d.finish_roughness = d.finish_absorption_per_m = d.finish_ior = -1;
  write_defaults(desc, struct_size, d);
}

void ups_collimator_desc_init(ups_collimator_desc* desc, uint32_t struct_size) {
  ups_collimator_desc d{};
  set_identity(d.to_fixture);
  d.smooth = 1;
  d.finish = UPS_FINISH_PMMA;
  d.finish_roughness = d.finish_absorption_per_m = d.finish_ior = -1;
  write_defaults(desc, struct_size, d);
}

void ups_fixture_part_desc_init(ups_fixture_part_desc* desc, uint32_t struct_size) {
  ups_fixture_part_desc d{};
  set_identity(d.to_fixture);
  d.finish = UPS_FINISH_MATTE_WHITE;
  d.finish_reflectance = d.finish_transmittance = d.finish_roughness = d.finish_absorption_per_m = d.finish_ior = -1;
  write_defaults(desc, struct_size, d);
}

void ups_fixture_instance_desc_init(ups_fixture_instance_desc* desc, uint32_t struct_size) {
  ups_fixture_instance_desc d{};
  set_identity(d.to_world);
  d.dimming = 1;
  d.flux_lm = -1;
  write_defaults(desc, struct_size, d);
}

// ---- fixtures ----

ups_status ups_fixture_create(ups_context* context, ups_fixture** out) {
  return guard(__func__, [&] {
    require(out, "out");
    require(context, "context");
    *out = new ups_fixture;
  });
}

void ups_fixture_destroy(ups_fixture* fixture) { destroy(fixture); }

ups_status ups_fixture_add_emitter(ups_fixture* fixture, const ups_fixture_emitter_desc* desc,
                                   ups_fixture_part_id* out) {
  return add(__func__, fixture, desc, &ups_fixture_emitter_desc_init, "emitter", out);
}

ups_status ups_fixture_add_reflector(ups_fixture* fixture, const ups_reflector_desc* desc, ups_fixture_part_id* out) {
  return add(__func__, fixture, desc, &ups_reflector_desc_init, "reflector", out);
}

ups_status ups_fixture_add_lens(ups_fixture* fixture, const ups_lens_desc* desc, ups_fixture_part_id* out) {
  return add(__func__, fixture, desc, &ups_lens_desc_init, "lens", out);
}

ups_status ups_fixture_add_collimator(ups_fixture* fixture, const ups_collimator_desc* desc, ups_fixture_part_id* out) {
  return add(__func__, fixture, desc, &ups_collimator_desc_init, "collimator", out);
}

ups_status ups_fixture_add_part(ups_fixture* fixture, const ups_fixture_part_desc* desc, ups_fixture_part_id* out) {
  return add(__func__, fixture, desc, &ups_fixture_part_desc_init, "mesh", out);
}

ups_status ups_fixture_get_info(const ups_fixture* fixture, ups_fixture_info* info) {
  return guard(__func__, [&] {
    const Fixture& f = require(fixture, "fixture").data;
    ups_fixture_info i{};
    i.part_count = uint32_t(f.parts.size());
    i.flux_lm = f.flux_lm();
    for (const auto& part : f.parts) {
      i.triangle_count += part->mesh.triangle_count();
      i.emitter_area_m2 += part->area_m2;
    }
    write_info(info, i, "info");
  });
}

// ---- in a scene ----

ups_status ups_scene_add_fixture(ups_scene* scene, const ups_fixture* fixture, const ups_fixture_instance_desc* desc,
                                 ups_fixture_id* out) {
  return guard(__func__, [&] {
    PlacedFixtures& fixtures = require(scene, "scene").fixtures;
    const Fixture& f = require(fixture, "fixture").data;
    require(out, "out");
    *out = fixtures.add(f, read_desc(desc, &ups_fixture_instance_desc_init));
  });
}

ups_status ups_scene_get_fixture_instance(const ups_scene* scene, ups_fixture_id id, ups_fixture_part_id part,
                                          ups_instance_id* out) {
  return guard(__func__, [&] {
    const PlacedFixtures& fixtures = require(scene, "scene").fixtures;
    require(out, "out") = fixtures.instance(id, part);
  });
}

ups_status ups_scene_set_fixture(ups_scene* scene, ups_fixture_id id, const ups_fixture_instance_desc* desc) {
  return guard(__func__, [&] {
    PlacedFixtures& fixtures = require(scene, "scene").fixtures;
    fixtures.set(id, read_desc(desc, &ups_fixture_instance_desc_init));
  });
}

ups_status ups_scene_get_fixture(const ups_scene* scene, ups_fixture_id id, ups_fixture_instance_desc* desc) {
  return guard(__func__, [&] { write_info(desc, require(scene, "scene").fixtures.get(id), "desc"); });
}

ups_status ups_scene_set_fixture_dimming(ups_scene* scene, ups_fixture_id id, float dimming) {
  return guard(__func__, [&] { require(scene, "scene").fixtures.set_dimming(id, dimming); });
}

ups_status ups_scene_set_fixture_transform(ups_scene* scene, ups_fixture_id id, const double to_world[12]) {
  return guard(__func__, [&] {
    PlacedFixtures& fixtures = require(scene, "scene").fixtures;
    check::pointer(to_world, "to_world");
    double copy[12];
    std::copy(to_world, to_world + 12, copy);
    fixtures.set_transform(id, copy);
  });
}

ups_status ups_scene_remove_fixture(ups_scene* scene, ups_fixture_id id) {
  return guard(__func__, [&] { require(scene, "scene").fixtures.remove(id); });
}
