// ups_fixture.h: defaults of the descs, parts of fixtures, and fixtures placed in scenes.
#include "api/desc.h"
#include "api/handles.h"
#include "scene/check.h"

using namespace ups;
using namespace ups::api;

namespace {

template <class Desc>
void at_origin(Desc& d) {
  set_identity(d.to_fixture);
}

// Adds what `desc` describes; errors say which part it would have been.
template <class Desc>
ups_status add(const char* function, ups_fixture* fixture, const Desc* desc, void (*init)(Desc*, uint32_t),
               const char* kind, ups_fixture_part_id* out) {
  return guard(function, [&] {
    ups_fixture& f = require(fixture, "fixture");
    const Desc d = read_desc(desc, init);
    const std::string name = "part " + std::to_string(f.parts.size() + 1) + " (" + kind + "): ";
    try {
      f.parts.push_back(std::make_shared<const FixturePart>(make_part(d)));
    } catch (const Error& e) {
      throw Error(e.status(), name + e.what());
    } catch (const std::invalid_argument& e) {
      fail_argument(name + e.what());
    }
    if (out) out->v = uint32_t(f.parts.size());
  });
}

double flux_of(const ups_fixture& fixture) {
  double sum = 0;
  for (const auto& part : fixture.parts) sum += std::max(0.0, part->flux_lm);
  return sum;
}

Affine operator*(const Affine& a, const Affine& b) {
  Affine out;
  for (int c = 0; c < 4; ++c) {
    const Vec3d v = c < 3 ? a.vector(b.column(c)) : a.point(b.column(3));
    out.m[c] = v.x, out.m[4 + c] = v.y, out.m[8 + c] = v.z;
  }
  return out;
}

void set_luminance(ups_material_desc& material, const FixturePart& part, double flux_scale) {
  const double luminance = part.flux_lm * flux_scale / (optics::pi * part.area_m2);
  const float rgb[3] = {part.color.r, part.color.g, part.color.b};
  for (int i = 0; i < 3; ++i) {
    material.luminance_cd_m2[i] = float(luminance * double(rgb[i]));
    check::require(std::isfinite(material.luminance_cd_m2[i]),
                   "dimming times flux_lm gives an emitter of " + check::text(part.area_m2) +
                       " m^2 a luminance that is not finite; it must be less");
  }
}

// Before anything is changed.
void check_luminance(const FixturePart& part, double flux_scale) {
  ups_material_desc material = part.material;
  if (part.flux_lm >= 0) set_luminance(material, part, flux_scale);
}

ups_mesh_id add_mesh(Description& scene, const FixturePart& part, ups_material_id material) {
  ups_mesh_desc d{};
  d.vertex_count = uint32_t(part.mesh.positions.size() / 3);
  d.triangle_count = uint32_t(part.mesh.triangle_count());
  d.material = material;
  d.positions_m = part.mesh.positions.data();
  d.normals = part.mesh.normals.empty() ? nullptr : part.mesh.normals.data();
  d.indices = part.mesh.indices.data();
  return scene.add_mesh(d, part.revolution);
}

// Emitters have a mesh and a material of their own each time, as their luminance is that of one placement.
PlacedFixture::Part place(ups_scene& scene, const std::shared_ptr<const FixturePart>& part, const Affine& to_world,
                          double flux_scale, uint32_t group) {
  PlacedFixture::Part placed{{}, part, {}};
  ups_instance_desc d{};
  d.group = group;
  if (part->flux_lm >= 0) {
    ups_material_desc material = part->material;
    set_luminance(material, *part, flux_scale);
    placed.material = scene.description.add_material(material);
    d.mesh = add_mesh(scene.description, *part, placed.material);
  } else {
    const auto [shared, fresh] = scene.fixture_meshes.try_emplace(part);
    if (fresh) shared->second = add_mesh(scene.description, *part, scene.description.add_material(part->material));
    d.mesh = shared->second;
  }
  const Affine m = to_world * part->to_fixture;
  std::copy(std::begin(m.m), std::end(m.m), d.to_world);
  placed.instance = scene.description.add_instance(d);
  return placed;
}

template <class Change>
ups_status change(const char* function, ups_scene* scene, ups_fixture_id id, const Change& body) {
  return guard(function, [&] {
    ups_scene& s = require(scene, "scene");
    body(s, s.fixtures.get(id.v, "fixture"));
  });
}

}  // namespace

// ---- defaults ----

void ups_fixture_emitter_desc_init(ups_fixture_emitter_desc* desc, uint32_t struct_size) {
  ups_fixture_emitter_desc d{};
  at_origin(d);
  for (float& c : d.color_rgb) c = 1;
  write_defaults(desc, struct_size, d);
}

void ups_reflector_desc_init(ups_reflector_desc* desc, uint32_t struct_size) {
  ups_reflector_desc d{};
  at_origin(d);
  d.smooth = 1;
  d.finish = UPS_FINISH_SPECULAR_ALUMINIUM;
  d.finish_reflectance = d.finish_transmittance = d.finish_roughness = -1;
  write_defaults(desc, struct_size, d);
}

void ups_lens_desc_init(ups_lens_desc* desc, uint32_t struct_size) {
  ups_lens_desc d{};
  at_origin(d);
  d.finish = UPS_FINISH_PMMA;
  d.finish_roughness = d.finish_absorption_per_m = d.finish_ior = -1;
  write_defaults(desc, struct_size, d);
}

void ups_collimator_desc_init(ups_collimator_desc* desc, uint32_t struct_size) {
  ups_collimator_desc d{};
  at_origin(d);
  d.smooth = 1;
  d.finish = UPS_FINISH_PMMA;
  d.finish_roughness = d.finish_absorption_per_m = d.finish_ior = -1;
  write_defaults(desc, struct_size, d);
}

void ups_fixture_part_desc_init(ups_fixture_part_desc* desc, uint32_t struct_size) {
  ups_fixture_part_desc d{};
  at_origin(d);
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
    const ups_fixture& f = require(fixture, "fixture");
    ups_fixture_info i{};
    i.part_count = uint32_t(f.parts.size());
    i.flux_lm = flux_of(f);
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
    ups_scene& s = require(scene, "scene");
    const ups_fixture& f = require(fixture, "fixture");
    require(out, "out");
    const ups_fixture_instance_desc d = read_desc(desc, &ups_fixture_instance_desc_init);
    const Affine to_world = rigid(d.to_world, "to_world");
    check::require(!f.parts.empty(), "fixture has no parts; add an emitter at least");
    check::at_least(double(d.dimming), 0, "dimming");
    check::finite(double(d.flux_lm), "flux_lm");
    const double flux = flux_of(f);
    check::require(d.flux_lm <= 0 || flux > 0, "flux_lm is " + check::text(double(d.flux_lm)) +
                                                   ", but the fixture's emitters have no flux to be scaled to it");
    PlacedFixture placed;
    if (d.flux_lm >= 0) placed.flux_scale = flux > 0 ? double(d.flux_lm) / flux : 0;
    const double scale = placed.flux_scale * double(d.dimming);
    for (const auto& part : f.parts) check_luminance(*part, scale);
    for (const auto& part : f.parts) placed.parts.push_back(place(s, part, to_world, scale, d.group));
    out->v = s.fixtures.add(std::move(placed));
  });
}

ups_status ups_scene_get_fixture_instance(const ups_scene* scene, ups_fixture_id id, ups_fixture_part_id part,
                                          ups_instance_id* out) {
  return guard(__func__, [&] {
    const PlacedFixture& fixture = require(scene, "scene").fixtures.get(id.v, "fixture");
    require(out, "out");
    check::require(part.v >= 1 && part.v <= fixture.parts.size(),
                   "part " + std::to_string(part.v) + " is not of this fixture; it was placed with " +
                       std::to_string(fixture.parts.size()) + " parts, counted from 1");
    *out = fixture.parts[part.v - 1].instance;
  });
}

ups_status ups_scene_set_fixture_dimming(ups_scene* scene, ups_fixture_id id, float dimming) {
  return change(__func__, scene, id, [&](ups_scene& s, PlacedFixture& fixture) {
    check::at_least(double(dimming), 0, "dimming");
    const double scale = fixture.flux_scale * double(dimming);
    for (const PlacedFixture::Part& placed : fixture.parts) check_luminance(*placed.part, scale);
    for (const PlacedFixture::Part& placed : fixture.parts) {
      if (placed.material.v == 0) continue;
      ups_material_desc material = s.description.materials().get(placed.material.v, "material");
      set_luminance(material, *placed.part, scale);
      s.description.set_material(placed.material, material);
    }
  });
}

ups_status ups_scene_set_fixture_transform(ups_scene* scene, ups_fixture_id id, const double to_world[12]) {
  return change(__func__, scene, id, [&](ups_scene& s, PlacedFixture& fixture) {
    check::pointer(to_world, "to_world");
    double copy[12];
    std::copy(to_world, to_world + 12, copy);
    const Affine frame = rigid(copy, "to_world");
    for (const PlacedFixture::Part& placed : fixture.parts) {
      const Affine m = frame * placed.part->to_fixture;
      s.description.set_transform(placed.instance, m.m);
    }
  });
}

ups_status ups_scene_remove_fixture(ups_scene* scene, ups_fixture_id id) {
  return change(__func__, scene, id, [&](ups_scene& s, PlacedFixture& fixture) {
    for (const PlacedFixture::Part& placed : fixture.parts) s.description.remove_instance(placed.instance);
    s.fixtures.remove(id.v, "fixture");
  });
}
