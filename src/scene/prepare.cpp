// See prepare.h. The steps in order: place, materials, geometry, emitters, sensors, media, effects and warnings.
#include "scene/prepare.h"

#include "base/parallel.h"
#include "geometry/box.h"
#include "scene/builder.h"
#include "scene/check.h"
#include "scene/effects.h"
#include "scene/probe.h"

namespace ups {
namespace {

constexpr double max_coordinate_m = 1e9;

}  // namespace

std::shared_ptr<const Snapshot> Builder::build() {
  out_->tag = in_.tag();
  out_->maintenance_factor = in_.maintenance_factor();
  place();
  add_materials();
  add_geometry();
  add_emissive_instances();
  out_->panes = find_panes(*out_, instances_);
  add_sources();
  std::vector<float> exposed;
  if (EmitterSet::uses_exposed(emitters_.size()))
    for (const auto& e : emitters_) exposed.push_back(exposed_share(*out_, *e));
  out_->emitters = EmitterSet(std::move(emitters_), exposed);
  if (!openings_.empty()) out_->openings = std::make_unique<DiscIndex>(std::move(openings_), threads_);
  add_sensors();
  find_media();
  out_->effects = find_effects(*out_);
  out_->effects.concentration = first_light_concentration(*out_, threads_);
  add_warnings();
  return out_;
}

// ---- place ----

// The origin is the centre of all that has a place; distances from it are what floats have to hold.
void Builder::place() {
  Box box;
  const auto grow = [&](const Vec3d& p, const char* noun, uint32_t id) {
    if (!(max_abs(p) <= max_coordinate_m))
      fail_argument(std::string(noun) + " id " + std::to_string(id) + " reaches a coordinate of " +
                    check::text(max_abs(p)) + " m; the library works within " + check::text(max_coordinate_m) +
                    " m of the world's origin");
    box.grow(p);
  };
  std::map<uint32_t, Box> mesh_boxes;
  in_.instances().each([&](uint32_t id, const InstanceDescription& i) {
    Box& mesh = mesh_boxes[i.mesh];
    if (mesh.empty())
      for (const Vec3& p : in_.meshes().at(i.mesh)->positions) mesh.grow(Vec3d(p));
    for (int k = 0; k < 8; ++k) grow(i.to_world.point(mesh.corner(k)), "instance", id);
  });
  in_.sources().each([&](uint32_t id, const SourceDescription& s) {
    if (const auto* light = std::get_if<LightDescription>(&s.kind)) {
      if (light->kind != UPS_LIGHT_DIRECTIONAL) grow(light->to_world.column(3), "luminaire", id);
      return;
    }
    const auto& luminaire = std::get<LuminaireDescription>(s.kind);
    if (const auto rays = rays_of(luminaire)) {
      const Axes axes(luminaire.to_world);
      const Vec3 low = rays->lower(), high = rays->upper();
      for (int k = 0; k < 8; ++k)
        grow(luminaire.to_world.column(3) + axes.x * double(k & 1 ? high.x : low.x) +
                 axes.y * double(k & 2 ? high.y : low.y) + axes.z * double(k & 4 ? high.z : low.z),
             "luminaire", id);
      return;
    }
    const float* size = luminaire.profile->opening.size_m;
    const double reach =
        luminaire.use_opening ? 0.5 * std::hypot(double(size[0]), double(size[1]), double(size[2])) : 0;
    const Vec3d p = luminaire.to_world.column(3), r(reach, reach, reach);
    grow(p - r, "luminaire", id);
    grow(p + r, "luminaire", id);
  });
  in_.sensors().each([&](uint32_t id, const Description::Sensor& s) {
    if (const auto* camera = std::get_if<CameraDescription>(&s)) return grow(camera->to_world.column(3), "sensor", id);
    if (const auto* o = std::get_if<ObserverDescription>(&s)) return grow(o->to_world.column(3), "sensor", id);
    const auto* meters = std::get_if<MetersDescription>(&s);
    if (!meters) return;  // a goniometer is at infinity, what measures a surface lies on it
    const double reach = 0.5 * std::max(std::hypot(double(meters->cell_width), double(meters->cell_height)),
                                        double(meters->footprint));
    for (const Vec3d& p : *meters->positions) {
      grow(p - Vec3d(reach, reach, reach), "sensor", id);
      grow(p + Vec3d(reach, reach, reach), "sensor", id);
    }
  });
  if (box.empty()) return;
  out_->origin = box.lower * 0.5 + box.upper * 0.5;
  out_->radius = float(length(box.upper - box.lower) * 0.5 * (1 + 0x1p-20));
}

// ---- surfaces ----

void Builder::add_materials() {
  const auto texture = [&](ups_texture_id id) -> const Texture* {
    return id.v ? out_->textures[number_of(id.v) - 1].get() : nullptr;
  };
  in_.textures().each([&](uint32_t, const TextureDescription& t) { out_->textures.push_back(t.texture); });
  in_.materials().each([&](uint32_t id, const MaterialDescription& d) {
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
    prepare_interface(m);
    out_->materials.push_back(m);
    SurfaceTexturing t;
    t.alpha = texture(d.alpha_texture);
    t.alpha_factor = d.alpha, t.alpha_cutoff = d.alpha_cutoff;
    t.normal = texture(d.normal_texture);
    t.normal_scale = d.normal_scale;
    if (d.alpha_mode == UPS_ALPHA_MASK) t.alpha_mode = SurfaceTexturing::mask;
    if (d.alpha_mode == UPS_ALPHA_BLEND && (t.alpha || t.alpha_factor < 1)) t.alpha_mode = SurfaceTexturing::blend;
    if (t.alpha_mode != SurfaceTexturing::opaque && !is_black(to_rgb(d.luminance_cd_m2))) {
      t.alpha_mode = SurfaceTexturing::opaque;  // holes in an emitter would have to be left out of its sampling too
      warn_of("material", id, "emits light: the alpha is ignored, so there are no holes in what bears it");
    }
    out_->texturing.push_back(t);
  });
  out_->material_used.resize(out_->materials.size());
}

namespace {

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

void Builder::add_geometry() {
  in_.meshes().each([&](uint32_t, const std::shared_ptr<const Mesh>& mesh) { out_->meshes.push_back(mesh); });
  in_.instances().each([&](uint32_t id, const InstanceDescription& i) {
    const Mesh& mesh = *out_->meshes[i.mesh - 1];
    instances_.push_back({i.mesh - 1, to_scene(i.to_world)});
    if (emits_from_one_side(in_.materials().at(mesh.material + 1)))
      lift_flat_emitter(mesh, 8 * 0x1p-24 * double(out_->radius), instances_.back().to_scene);
    out_->instance_ids.push_back(id);
    out_->material_used[out_->meshes[i.mesh - 1]->material] = true;
  });
  out_->media = rank_media(out_->meshes, instances_, out_->materials, out_->texturing);
  out_->raytracer =
      std::make_unique<Raytracer>(out_->meshes, instances_, out_->texturing, threads_, out_->media.nest);
}

// ---- sensors ----

void Builder::add_sensors() {
  in_.sensors().each([&](uint32_t id, const Description::Sensor& s) {
    if (const auto* c = std::get_if<CameraDescription>(&s)) {
      out_->cameras.emplace_back(to_scene(c->to_world), c->width, c->height, c->vertical_fov_rad, c->illuminance,
                                 Projection(c->projection), c->layers);
      out_->camera_ids.push_back(id);
    } else if (const auto* g = std::get_if<GoniometerDescription>(&s)) {
      out_->goniometers.emplace_back(Axes(g->to_world).frame(), g->c_deg, g->gamma_deg,
                                     Goniometer::Symmetry(g->symmetry));
      out_->goniometer_openings.push_back(g->opening);
      out_->goniometer_ids.push_back(id);
    } else if (const auto* o = std::get_if<ObserverDescription>(&s)) {
      const Axes axes(o->to_world);
      MetersDescription eye{};
      eye.positions = std::make_shared<const std::vector<Vec3d>>(1, o->to_world.column(3));
      eye.normals = {Vec3(-axes.z)};
      out_->observers.push_back({uint32_t(out_->meter_sets.size()), axes.frame(),
                                 photometry::PositionIndex(o->position_index), double(o->ceiling_area)});
      out_->observer_ids.push_back(id);
      out_->meter_sets.push_back(make_meters(eye));
      out_->meter_set_ids.push_back(id);
    } else {
      const auto* surface = std::get_if<SurfaceMetersDescription>(&s);
      in_context("sensor id " + std::to_string(id), [&] {
        out_->meter_sets.push_back(surface ? make_surface_meters(id, *surface)
                                           : make_meters(std::get<MetersDescription>(s)));
      });
      out_->meter_set_ids.push_back(id);
    }
  });
}

// ---- media ----

// Where there is glass that attenuates, or bends light by what lies around it.
void Builder::find_media() {
  bool wanted = out_->media.nest;
  for (const Medium& m : out_->media.by_rank) wanted |= !is_black(out_->materials[m.material].absorption_per_m);
  std::vector<MediaStack>& stacks = out_->media_stacks;
  stacks.assign(1, MediaStack());
  const auto number = [&](const MediaStack& stack) {
    const auto at = std::find(stacks.begin(), stacks.end(), stack);
    if (at != stacks.end()) return uint32_t(at - stacks.begin());
    stacks.push_back(stack);
    return uint32_t(stacks.size() - 1);
  };
  const auto find = [&](const Vec3& p) { return wanted ? number(media_at(*out_, p)) : 0; };
  for (const Camera& camera : out_->cameras) out_->media_of_camera.push_back(find(camera.position()));
  for (const Vec3& p : emitter_probes_) out_->media_of_emitter.push_back(find(p));
  for (const MeterSet& set : out_->meter_sets) {
    std::vector<uint32_t>& media = out_->media_of_meter.emplace_back(set.meters.size(), 0);
    if (!wanted) continue;
    std::vector<MediaStack> found(set.meters.size());
    parallel_for(threads_, set.meters.size(), [&](size_t i) {
      const Meter meter = set.is_cell() ? set.sample(i, {0.5f, 0.5f}) : set.meters[i];
      found[i] = media_at(*out_, meter.p + meter.frame.n * (2 * meter.error));
    });
    for (size_t i = 0; i < found.size(); ++i) media[i] = number(found[i]);
  }
}

std::shared_ptr<const Snapshot> prepare(const Description& description, ThreadPool& pool) {
  return Builder(description, pool).build();
}

}  // namespace ups
