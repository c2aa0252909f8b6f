// See builder.h: meshes, materials and textures that instances show, the ray tracer, panes.
#include <algorithm>
#include <cstring>

#include "bsdf/albedo.h"
#include "bsdf/fresnel.h"
#include "scene/builder.h"
#include "scene/check.h"
#include "scene/close_surfaces.h"
#include "scene/length_text.h"

namespace ups {
namespace {

// Where a number is in an ascending list; none: it is not.
uint32_t rank_of(const std::vector<uint32_t>& numbers, uint32_t number) {
  const auto at = std::lower_bound(numbers.begin(), numbers.end(), number);
  return at != numbers.end() && *at == number ? uint32_t(at - numbers.begin()) : none;
}

void sort_out(std::vector<uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

bool emits_from_one_side(const ups_material_desc& m) {
  return m.emits_both_sides != 1 && (m.luminance_cd_m2[0] > 0 || m.luminance_cd_m2[1] > 0 || m.luminance_cd_m2[2] > 0);
}

// A flat emitter may lie in the plane of a ceiling that goes on behind it. Rounding would decide which of the two a ray
// meets, and half of the light be lost: it is moved to its front by what rounding makes, some micrometres in a room.
void lift_flat_emitter(const Mesh& mesh, double lift, Affine& to_scene) {
  if (mesh.revolution) return;
  const double side = to_scene.determinant() < 0 ? -1 : 1;
  const auto at = [&](size_t i) { return to_scene.point(Vec3d(mesh.positions[mesh.indices[i]])); };
  Vec3d n(0, 0, 0);
  double flattest = 1;
  for (size_t t = 0; t < mesh.indices.size(); t += 3) {
    const Vec3d a = cross(at(t + 1) - at(t), at(t + 2) - at(t)) * side;
    const double size = length(a);
    if (!(size > 0)) continue;
    if (!(length(n) > 0)) n = a / size;
    flattest = std::min(flattest, dot(n, a / size));
  }
  if (!(length(n) > 0) || flattest < 0.9999) return;
  for (size_t i = 0; i < mesh.indices.size(); ++i)
    if (std::abs(dot(at(i) - at(0), n)) > lift) return;
  to_scene.m[3] += n.x * lift, to_scene.m[7] += n.y * lift, to_scene.m[11] += n.z * lift;
}

}  // namespace

// Instances, in the world's frame until the origin is known, and what they show.
void Builder::list_surfaces() {
  for (auto* list : {&out_->instance_ids, &out_->mesh_numbers, &out_->material_numbers}) list->clear();
  out_->instances.clear(), out_->meshes.clear(), out_->mesh_boxes.clear();
  in_.instances().each([&](uint32_t number, const InstanceDescription& i) {
    if (far_surfaces_.count(number)) return;
    out_->instances.push_back({i.mesh, i.to_world, number});
    out_->instance_ids.push_back(number);
    out_->mesh_numbers.push_back(i.mesh);
  });
  sort_out(out_->mesh_numbers);
  for (const uint32_t number : out_->mesh_numbers) {
    out_->meshes.push_back(in_.meshes().shared(number));
    out_->material_numbers.push_back(out_->meshes.back()->material_number);
  }
  std::vector<uint32_t> material_of_mesh = out_->material_numbers;
  sort_out(out_->material_numbers);
  for (uint32_t& material : material_of_mesh) material = rank_of(out_->material_numbers, material);
  for (Raytracer::Instance& i : out_->instances) {
    i.mesh = rank_of(out_->mesh_numbers, i.mesh);
    i.material = material_of_mesh[i.mesh];
  }
  for (size_t m = 0; m < out_->meshes.size(); ++m) out_->mesh_boxes.push_back(mesh_box(m));
}

Box Builder::mesh_box(size_t m) const {
  const uint32_t then = earlier_ ? rank_of(earlier_->mesh_numbers, out_->mesh_numbers[m]) : none;
  if (then != none && earlier_->meshes[then] == out_->meshes[m]) return earlier_->mesh_boxes[then];
  Box box;
  out_->meshes[m]->each_used([&](const Vec3& p) { box.grow(Vec3d(p)); });
  return box;
}

// ---- materials ----

// Light it scatters as the earlier build's material of that number, whatever it emits.
bool Builder::scatters_as_before(uint32_t number) const {
  if (!earlier_ || rank_of(earlier_->material_numbers, number) == none) return false;
  const auto &now = in_.materials().shared(number), &then = earlier_->described->materials().shared(number);
  for (const ups_texture_id id : {now->reflectance_texture, now->roughness_texture, now->metallic_texture,
                                  now->normal_texture, now->alpha_texture})
    if (in_.textures().find(number_of(id.v)) != earlier_->described->textures().find(number_of(id.v))) return false;
  if (now == then) return true;
  ups_material_desc a = *now, b = *then;
  for (ups_material_desc* d : {&a, &b}) {
    std::fill(std::begin(d->luminance_cd_m2), std::end(d->luminance_cd_m2), 0.0f);
    d->emits_both_sides = 0;
  }
  return now->pane == then->pane && std::memcmp(&a, &b, sizeof a) == 0;
}

const Texture* Builder::texture(ups_texture_id id) {
  if (id.v == 0) return nullptr;
  out_->textures.push_back(in_.textures().at(number_of(id.v)).texture);
  return out_->textures.back().get();
}

Material Builder::make_material(const MaterialDescription& d) {
  Material m;
  m.pane = d.pane;
  m.model = MaterialModel(d.model);
  m.reflectance = to_rgb(d.reflectance_rgb);
  m.transmittance = to_rgb(d.transmittance_rgb);  // < 0: a clear pane; other models let nothing through
  if (m.transmittance.r < 0 && m.model != MaterialModel::glazing) m.transmittance = {};
  m.roughness = d.roughness, m.ior = d.ior, m.metallic = d.metallic;
  m.ior_rgb = to_rgb(d.ior_rgb), m.ior_k_rgb = to_rgb(d.ior_k_rgb);
  m.absorption_per_m = to_rgb(d.absorption_per_m_rgb);
  m.priority = d.priority;
  m.reflectance_texture = texture(d.reflectance_texture);
  m.roughness_texture = texture(d.roughness_texture);
  m.metallic_texture = texture(d.metallic_texture);
  return m;
}

SurfaceTexturing Builder::make_texturing(uint32_t number, const MaterialDescription& d) {
  SurfaceTexturing t;
  t.alpha = texture(d.alpha_texture);
  t.alpha_factor = d.alpha, t.alpha_cutoff = d.alpha_cutoff;
  t.normal = texture(d.normal_texture);
  t.normal_scale = d.normal_scale;
  if (d.alpha_mode == UPS_ALPHA_MASK) t.alpha_mode = SurfaceTexturing::mask;
  if (d.alpha_mode == UPS_ALPHA_BLEND && (t.alpha || t.alpha_factor < 1)) t.alpha_mode = SurfaceTexturing::blend;
  if (t.alpha_mode != SurfaceTexturing::opaque && !is_black(to_rgb(d.luminance_cd_m2))) {
    t.alpha_mode = SurfaceTexturing::opaque;  // holes in an emitter would have to be left out of its sampling too
    warn_of("material", number, "emits light: the alpha is ignored, so there are no holes in what bears it");
  }
  if (t.alpha_mode != SurfaceTexturing::opaque && d.model == UPS_MATERIAL_GLASS) {
    const float whole = t.alpha_mode == SurfaceTexturing::mask ? t.alpha_cutoff : 1.0f;
    t.alpha_mode = SurfaceTexturing::opaque;  // a boundary with holes, or that is there for some light alone, bounds nothing
    if (t.alpha || t.alpha_factor < whole)
      warn_of("material", number, "is of glass, which bounds a solid and says itself what it lets through: its alpha is "
              "ignored, so there are no holes in it; GLAZING may have some");
  }
  if (t.alpha_mode == SurfaceTexturing::blend && d.model == UPS_MATERIAL_GLAZING)
    warn_of("material", number, "is a pane whose blended alpha (" + check::text(double(t.alpha_factor)) +
            (t.alpha ? ", times a texture" : "") + ") lets the rest of the light by beside what the pane transmits; a "
            "pane that is whole has an alpha of 1");
  return t;
}

// Of a plane-parallel pane without absorption: (1 - F) / (1 + F), all reflections within it summed.
void Builder::warn_of_transmittance(uint32_t number, const Material& m) {
  if (m.model != MaterialModel::glazing || m.pane) return;
  const float f = normal_reflectance(m.ior), clear = (1 - f) / (1 + f), asked = max_component(m.transmittance);
  if (asked <= clear * 1.0001f) return;
  warn_of("material", number, "a transmittance of " + check::text(double(asked)) + " is more than a clear pane of ior " +
          check::text(double(m.ior)) + " lets through at normal incidence: " + short_text(double(clear)) + " is taken");
}

// What rough ones return is known up to there; beyond, plastic would return more light than arrives, and glass less.
void Builder::limit_ior(uint32_t number, Material& m) {
  const bool dielectric = m.model == MaterialModel::plastic || m.model == MaterialModel::glass;
  if (!dielectric || m.ior <= max_rough_ior || !(m.roughness > 0)) return;
  warn_of("material", number, "is rough and has an ior of " + check::text(double(m.ior)) + ": " +
          check::text(double(max_rough_ior)) + " is taken, up to which it is known how much light rough PLASTIC and "
          "GLASS return");
  m.ior = max_rough_ior;
}

void Builder::add_materials() {
  same_surfaces_ = earlier_ && earlier_->material_numbers == out_->material_numbers;
  for (const uint32_t number : out_->material_numbers) {
    const MaterialDescription& d = in_.materials().at(number);
    Material m = make_material(d);
    limit_ior(number, m);
    if (scatters_as_before(number)) {
      const Material& before = earlier_->materials[rank_of(earlier_->material_numbers, number)];
      m.interface_albedo = before.interface_albedo, m.conductor_average = before.conductor_average;
    } else {
      prepare_interface(m), same_surfaces_ = false;
    }
    warn_of_transmittance(number, m);
    out_->materials.push_back(m);
    out_->texturing.push_back(make_texturing(number, d));
  }
}

// ---- geometry ----

void Builder::add_geometry() {
  std::vector<Raytracer::Instance>& instances = out_->instances;
  for (Raytracer::Instance& i : instances) {
    i.to_scene = to_scene(i.to_scene);
    if (emits_from_one_side(in_.materials().at(out_->material_numbers[i.material])))
      lift_flat_emitter(*out_->meshes[i.mesh], rounding_of_places(), i.to_scene);
  }
  const TouchableParts touchable = find_contacts();
  monitor_.begin_part(0.6f);
  set_back_emitters();
  // Whatever is known of their room already: a build without `earlier` knows nothing.
  const auto to_move = [](const auto& c) { return c.second.is_to_move(); };
  const auto blends = [](const SurfaceTexturing& t) { return t.alpha_mode == SurfaceTexturing::blend; };
  const auto is_of_glass = [&](const Raytracer::Instance& i) {
    const MaterialModel model = out_->materials[i.material].model;
    return model == MaterialModel::glazing || model == MaterialModel::glass;
  };
  out_->finds_all = std::any_of(out_->contacts.begin(), out_->contacts.end(), to_move) ||
                    std::any_of(out_->texturing.begin(), out_->texturing.end(), blends) ||
                    std::any_of(instances.begin(), instances.end(), is_of_glass);
  same_geometry_ = earlier_ && !contacts_differ_ && has_same_origin() && earlier_->instances.size() == instances.size() &&
                   earlier_->texturing == out_->texturing && earlier_->finds_all == out_->finds_all;
  for (size_t i = 0; same_geometry_ && i < instances.size(); ++i) same_geometry_ = is_same_instance(i);
  same_surfaces_ = same_surfaces_ && same_geometry_;
  out_->media = same_surfaces_ ? earlier_->media
                               : rank_media(out_->meshes, instances, out_->materials, out_->texturing);
  warn_of_inside_out();
  same_geometry_ = same_geometry_ && earlier_->media.nest == out_->media.nest;
  same_surfaces_ = same_surfaces_ && same_geometry_;
  same_places_ = same_surfaces_ && earlier_->radius == out_->radius;
  if (same_geometry_)
    out_->raytracer = earlier_->raytracer;
  else
    trace_surfaces(touchable);
}

void Builder::warn_of_inside_out() {
  for (size_t i = 0; i < out_->instances.size(); ++i)
    if (out_->media.is_inside_out(uint32_t(i)))
      warn_of("instance", out_->instance_ids[i],
              "a closed mesh of glass whose front is inwards: the glass is taken to lie within it; turn the winding of "
              "its triangles. A hollow in glass is a part of the same mesh, or a solid of ior 1");
}

// At the same index. Meshes and materials may have other indices.
bool Builder::is_same_instance(size_t i) const {
  if (!earlier_ || i >= earlier_->instances.size() || !has_same_origin()) return false;
  const Raytracer::Instance &now = out_->instances[i], &then = earlier_->instances[i];
  return now.number == then.number && now.to_scene == then.to_scene &&
         out_->meshes[now.mesh] == earlier_->meshes[then.mesh];
}

// Glazing that begins to emit is no pane any more: then probe rays may find other surfaces than they did. Where texturing
// changes, the ray tracer is another, too.
void Builder::add_panes() {
  find_panes_and_what_they_lie_on();
  constexpr float told = 0.25f;
  for (const PaneOnSurface& pane : out_->panes.on_surfaces)
    if (pane.covered > told)
      warn_of("instance", out_->instance_ids[pane.instance],
              "a pane that lies on instance " + std::to_string(out_->instance_ids[pane.opaque]) +
                  ", which no light goes through: cut an opening there");
}

void Builder::find_panes_and_what_they_lie_on() {
  if (same_places_ && earlier_->emitter_of_instance == out_->emitter_of_instance) {
    out_->panes = earlier_->panes;
    return;
  }
  out_->panes = find_panes(*out_, out_->instances);
  out_->panes.on_surfaces = find_panes_on_surfaces(*out_, threads_, monitor_);
  for (const PaneOnSurface& pane : out_->panes.on_surfaces) {
    out_->panes.on_surface.resize(out_->instances.size());
    out_->panes.on_surface[pane.instance] = true;
  }
  for (const uint32_t glass : find_touched_glass(*out_, threads_, monitor_)) {
    out_->panes.touched_glass.resize(out_->instances.size());
    out_->panes.touched_glass[glass] = true;
  }
  if (!same_places_ || out_->panes == earlier_->panes) return;
  same_places_ = same_emitters_ = false;
  for (EmitterProbe& probe : out_->emitter_probes) probe = {};
}

}  // namespace ups
