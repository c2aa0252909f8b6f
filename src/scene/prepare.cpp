// See prepare.h. The steps in order: place, materials, geometry, emitters, sensors, media, effects and warnings.
#include "scene/prepare.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/parallel.h"
#include "geometry/box.h"
#include "scene/builder.h"
#include "scene/check.h"
#include "scene/effects.h"
#include "scene/searched.h"

namespace ups {
namespace {

constexpr double max_coordinate_m = 1e9, least_extent_m = 1e-9;

}  // namespace

std::shared_ptr<const Snapshot> Builder::build() {
  out_->tag = in_.tag();
  out_->described = std::make_shared<const Description>(in_);
  out_->maintenance_factor = in_.maintenance_factor();
  place();
  add_materials();
  monitor_.begin_part(0.6f);
  add_geometry();
  monitor_.begin_part(0.7f);
  add_emissive_instances();
  add_panes();
  add_sources();
  find_exposed();
  if (earlier_ && earlier_->openings && earlier_->openings->holds(openings_))
    out_->openings = earlier_->openings;
  else if (!openings_.empty())
    out_->openings = std::make_shared<const DiscIndex>(std::move(openings_));
  monitor_.begin_part(0.8f);
  add_sensors();
  find_media();
  out_->effects = find_effects(*out_);
  find_concentration();
  monitor_.begin_part(1);
  share_searches();
  add_warnings();
  return out_;
}

// ---- place ----

// The origin is near the centre of all that has a place; distances from it are what floats have to hold. It stays
// while things move within these bounds, and a little beyond.
void Builder::place() {
  Box box;
  const auto grow = [&](const Vec3d& p, const char* noun, uint32_t id) {
    if (!(max_abs(p) <= max_coordinate_m))
      fail_argument(std::string(noun) + " id " + std::to_string(id) + " reaches a coordinate of " +
                    check::text(max_abs(p)) + " m; the library works within " + check::text(max_coordinate_m) +
                    " m of the world's origin");
    box.grow(p);
  };
  out_->mesh_boxes.resize(in_.meshes().last_number());
  in_.instances().each([&](uint32_t id, const InstanceDescription& i) {
    const Box& mesh = mesh_box(i.mesh);
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
    grow(meters->bounds.lower - Vec3d(reach, reach, reach), "sensor", id);
    grow(meters->bounds.upper + Vec3d(reach, reach, reach), "sensor", id);
  });
  if (box.empty()) return;
  const Vec3d size = box.upper - box.lower, middle = box.lower * 0.5 + box.upper * 0.5;
  out_->extent = std::exp2(std::ceil(std::log2(std::max({size.x, size.y, size.z, least_extent_m}))));
  const double step = out_->extent / 4;
  out_->origin = {step * std::round(middle.x / step), step * std::round(middle.y / step),
                  step * std::round(middle.z / step)};
  out_->centre = Vec3(middle - out_->origin);
  out_->radius = float(length(size) * 0.5 * (1 + 0x1p-20));
}

const Box& Builder::mesh_box(uint32_t number) {
  Box& box = out_->mesh_boxes[number - 1];
  if (!box.empty()) return box;
  const auto& mesh = in_.meshes().shared(number);
  if (earlier_ && number <= earlier_->meshes.size() && earlier_->meshes[number - 1] == mesh)
    box = earlier_->mesh_boxes[number - 1];
  if (box.empty())
    for (const Vec3& p : mesh->positions) box.grow(Vec3d(p));
  return box;
}

// ---- surfaces ----

// Light it scatters as the earlier build's material of that number, whatever it emits.
bool Builder::scatters_as_before(uint32_t number) const {
  if (!earlier_ || !earlier_->described->materials().holds(number)) return false;
  const auto &now = in_.materials().shared(number), &then = earlier_->described->materials().shared(number);
  const auto same_texture = [&](ups_texture_id id) {
    return id.v == 0 || in_.textures().shared(number_of(id.v)) == earlier_->described->textures().shared(number_of(id.v));
  };
  for (const ups_texture_id id : {now->reflectance_texture, now->roughness_texture, now->metallic_texture,
                                  now->normal_texture, now->alpha_texture})
    if (number_of(id.v) > earlier_->described->textures().last_number() || !same_texture(id)) return false;
  if (now == then) return true;
  ups_material_desc a = *now, b = *then;
  for (ups_material_desc* d : {&a, &b}) {
    std::fill(std::begin(d->luminance_cd_m2), std::end(d->luminance_cd_m2), 0.0f);
    d->emits_both_sides = 0;
  }
  return now->pane == then->pane && std::memcmp(&a, &b, sizeof a) == 0;
}

void Builder::add_materials() {
  const auto texture = [&](ups_texture_id id) -> const Texture* {
    return id.v ? out_->textures[number_of(id.v) - 1].get() : nullptr;
  };
  out_->textures.resize(in_.textures().last_number());
  in_.textures().each([&](uint32_t id, const TextureDescription& t) { out_->textures[id - 1] = t.texture; });
  out_->materials.resize(in_.materials().last_number());
  out_->texturing.resize(out_->materials.size());
  same_surfaces_ = earlier_ && earlier_->materials.size() == out_->materials.size();
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
    if (scatters_as_before(id))
      m.interface_albedo = earlier_->materials[id - 1].interface_albedo;
    else
      prepare_interface(m), same_surfaces_ = false;
    out_->materials[id - 1] = m;
    SurfaceTexturing& t = out_->texturing[id - 1];
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
  std::vector<Raytracer::Instance>& instances = out_->instances;
  out_->meshes.resize(in_.meshes().last_number());
  in_.instances().each([&](uint32_t id, const InstanceDescription& i) {
    out_->meshes[i.mesh - 1] = in_.meshes().shared(i.mesh);
    const Mesh& mesh = *out_->meshes[i.mesh - 1];
    instances.push_back({i.mesh - 1, to_scene(i.to_world), id});
    if (emits_from_one_side(in_.materials().at(mesh.material + 1)))
      lift_flat_emitter(mesh, 4 * 0x1p-24 * out_->extent, instances.back().to_scene);
    out_->instance_ids.push_back(id);
    out_->material_used[mesh.material] = true;
  });
  same_geometry_ = earlier_ && has_same_origin() && earlier_->instances == instances &&
                   earlier_->texturing == out_->texturing;
  for (size_t i = 0; same_geometry_ && i < instances.size(); ++i) same_geometry_ = is_same_instance(i);
  same_surfaces_ = same_surfaces_ && same_geometry_;
  out_->media = same_surfaces_ ? earlier_->media
                               : rank_media(out_->meshes, instances, out_->materials, out_->texturing);
  same_geometry_ = same_geometry_ && earlier_->media.nest == out_->media.nest;
  same_surfaces_ = same_surfaces_ && same_geometry_;
  same_places_ = same_surfaces_ && earlier_->radius == out_->radius;
  if (same_geometry_)
    out_->raytracer = earlier_->raytracer;
  else
    out_->raytracer =
        std::make_shared<const Raytracer>(out_->meshes, instances, out_->texturing, threads_, out_->media.nest,
                                          earlier_ ? earlier_->raytracer.get() : nullptr, &monitor_);
}

bool Builder::is_same_instance(size_t i) const {
  if (!earlier_ || i >= earlier_->instances.size() || !has_same_origin()) return false;
  const Raytracer::Instance &now = out_->instances[i], &then = earlier_->instances[i];
  return now == then && out_->meshes[now.mesh] == earlier_->meshes[then.mesh];
}

// Glazing that begins to emit is no pane any more: then probe rays may find other surfaces than they did.
void Builder::add_panes() {
  if (same_places_ && earlier_->emitter_of_instance == out_->emitter_of_instance) {
    out_->panes = earlier_->panes;
    return;
  }
  out_->panes = find_panes(*out_, out_->instances);
  if (!same_places_ || out_->panes.of_instance == earlier_->panes.of_instance) return;
  same_places_ = same_emitters_ = false;
  for (EmitterProbe& probe : out_->emitter_probes) probe = {};
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
      out_->observers.push_back({uint32_t(out_->meter_sets.size()), axes.frame(),
                                 photometry::PositionIndex(o->position_index), double(o->ceiling_area)});
      out_->observer_ids.push_back(id);
      add_meter_set(id, [&] {
        MetersDescription eye{};
        eye.positions = std::make_shared<const std::vector<Vec3d>>(1, o->to_world.column(3));
        eye.normals = {Vec3(-axes.z)};
        return make_meters(eye);
      });
    } else {
      const auto* surface = std::get_if<SurfaceMetersDescription>(&s);
      add_meter_set(id, [&] {
        return surface ? make_surface_meters(id, *surface) : make_meters(std::get<MetersDescription>(s));
      });
    }
  });
}

void Builder::add_meter_set(uint32_t id, const std::function<MeterSet()>& make) {
  const auto earlier_set = [&]() -> std::shared_ptr<MeterSet> {
    if (!same_places_ || !earlier_->described->sensors().holds(id)) return nullptr;
    if (earlier_->described->sensors().shared(id) != in_.sensors().shared(id)) return nullptr;
    const auto at = std::lower_bound(earlier_->meter_set_ids.begin(), earlier_->meter_set_ids.end(), id);
    return earlier_->meter_sets.shared(size_t(at - earlier_->meter_set_ids.begin()));
  };
  if (const auto set = earlier_set()) {
    out_->meter_sets.push_back(set);
    if (const auto warned = earlier_->sensor_warnings.find(id); warned != earlier_->sensor_warnings.end())
      out_->sensor_warnings.insert(*warned);
  } else {
    in_context("sensor id " + std::to_string(id), [&] { out_->meter_sets.push_back(make()); });
  }
  out_->meter_set_ids.push_back(id);
  if (const auto warned = out_->sensor_warnings.find(id); warned != out_->sensor_warnings.end())
    for (const std::string& text : warned->second) warn(text);
}

bool Builder::sensors_are_same() const {
  const auto &now = in_.sensors(), &then = earlier_->described->sensors();
  if (now.last_number() != then.last_number()) return false;
  for (uint32_t n = 1; n <= now.last_number(); ++n)
    if (now.shared(n) != then.shared(n)) return false;
  return true;
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
  const bool is_same = same_places_ && sensors_are_same();
  if (wanted && is_same) {  // the emitters' own follow those of sensors
    stacks.assign(earlier_->media_stacks.begin(), earlier_->media_stacks.begin() + earlier_->sensor_media_count);
    out_->media_of_camera = earlier_->media_of_camera;
    out_->media_of_meter = earlier_->media_of_meter;
  }
  for (size_t c = out_->media_of_camera.size(); c < out_->cameras.size(); ++c)
    out_->media_of_camera.push_back(find(out_->cameras[c].position()));
  for (size_t s = out_->media_of_meter.size(); s < out_->meter_sets.size(); ++s) {
    const MeterSet& set = out_->meter_sets[s];
    std::vector<uint32_t>& media = out_->media_of_meter.emplace_back(set.meters.size(), 0);
    if (!wanted) continue;
    std::vector<MediaStack> found(set.meters.size());
    parallel_for(threads_, set.meters.size(), [&](size_t i) {
      const Meter meter = set.is_cell() ? set.sample(i, {0.5f, 0.5f}) : set.meters[i];
      found[i] = media_at(*out_, meter.p + meter.frame.n * (2 * meter.error));
    });
    for (size_t i = 0; i < found.size(); ++i) media[i] = number(found[i]);
  }
  out_->sensor_media_count = stacks.size();
  for (const Vec3& p : emitter_fronts_) out_->media_of_emitter.push_back(find(p));
}

// What nothing has changed for is not searched again.
void Builder::share_searches() {
  out_->surface_search = same_surfaces_ ? earlier_->surface_search : std::make_shared<SearchedWarnings>();
  out_->light_search = same_places_ && same_emitters_ && sensors_are_same() ? earlier_->light_search
                                                                            : std::make_shared<SearchedWarnings>();
}

std::shared_ptr<const Snapshot> prepare(const Description& description, ThreadPool& pool,
                                        const std::shared_ptr<const Snapshot>& earlier, Monitor* monitor) {
  Monitor nobody;
  auto scene = Builder(description, pool, earlier.get(), monitor ? *monitor : nobody).build();
  if (!earlier) searched_warnings(*scene, pool);
  return scene;
}

}  // namespace ups
