// See prepare.h. The steps in order: place, materials, geometry, emitters, sensors, media, effects and warnings.
#include "scene/prepare.h"

#include <map>

#include "base/parallel.h"
#include "emitter/area.h"
#include "emitter/point.h"
#include "emitter/profile.h"
#include "emitter/rays.h"
#include "geometry/box.h"
#include "scene/check.h"
#include "scene/duplicates.h"
#include "scene/effects.h"
#include "scene/probe.h"

namespace ups {
namespace {

constexpr double max_coordinate_m = 1e9;

Rgb to_rgb(const float (&c)[3]) { return {c[0], c[1], c[2]}; }

// Axes of a placed thing whose scale does not matter: z first, then x.
struct Axes {
  Vec3d x, y, z;
  explicit Axes(const Affine& m) : z(normalize(m.column(2))) {
    x = normalize(m.column(0) - z * dot(m.column(0), z));
    y = cross(z, x);
  }
  Frame frame() const { return {Vec3(x), Vec3(y), Vec3(z)}; }
};

// Errors of what is built inside say whose they are.
template <class Build>
void in_context(const std::string& name, const Build& build) {
  try {
    build();
  } catch (const Error& e) {
    throw Error(e.status(), name + ": " + e.what());
  }
}

class Builder {
 public:
  Builder(const Description& description, int thread_count)
      : in_(description), threads_(thread_count), out_(std::make_shared<Snapshot>()) {}

  std::shared_ptr<const Snapshot> build() {
    place();
    add_materials();
    add_geometry();
    add_emissive_instances();
    add_sources();
    std::vector<float> exposed;
    if (EmitterSet::uses_exposed(emitters_.size()))
      for (const auto& e : emitters_) exposed.push_back(exposed_share(*out_, *e));
    out_->emitters = EmitterSet(std::move(emitters_), exposed);
    if (!openings_.empty()) out_->openings = std::make_unique<DiscIndex>(std::move(openings_), threads_);
    add_sensors();
    find_media();
    out_->effects = find_effects(*out_);
    add_warnings();
    return out_;
  }

 private:
  void place();
  void add_materials();
  void add_geometry();
  void add_emissive_instances();
  void add_sources();
  void add_light(const std::string& name, const LightDescription& light, float dimming);
  void add_luminaire(const std::string& name, const LuminaireDescription& luminaire, float dimming);
  float opening_error(const Vec3& p, const Frame& frame, const photometry::Opening& opening) const;
  std::shared_ptr<const RaySet> rays_of(const LuminaireDescription& luminaire);
  void add_rays(const std::string& name, const LuminaireDescription& luminaire, const Rgb& scale);
  bool add_emitter(const std::string& name, std::unique_ptr<Emitter> emitter, const Vec3& probe);
  void add_sensors();
  MeterSet make_meters(const MetersDescription& meters) const;
  void find_media();
  void add_warnings();

  Affine to_scene(Affine m) const {
    m.m[3] -= out_->origin.x, m.m[7] -= out_->origin.y, m.m[11] -= out_->origin.z;
    return m;
  }
  Vec3 to_scene(const Vec3d& p) const { return Vec3(p - out_->origin); }
  void warn(std::string text) { out_->warnings.push_back(std::move(text)); }

  const Description& in_;
  int threads_;
  std::shared_ptr<Snapshot> out_;
  std::vector<Raytracer::Instance> instances_;
  std::vector<uint32_t> instance_ids_;
  std::vector<std::unique_ptr<Emitter>> emitters_;
  std::vector<Vec3> emitter_probes_;  // a point of each, off any surface
  std::vector<DiscIndex::Disc> openings_;
  std::map<const photometry::Photometry*, std::shared_ptr<const RaySet>> ray_sets_;  // one a profile
};

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
      for (const Vec3& p : in_.meshes().get(i.mesh, "mesh")->positions) mesh.grow(Vec3d(p));
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
    if (std::holds_alternative<GoniometerDescription>(s)) return;  // at infinity
    const auto& meters = std::get<MetersDescription>(s);
    const double reach = 0.5 * std::hypot(double(meters.cell_width), double(meters.cell_height));
    for (const Vec3d& p : meters.positions) {
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
    return id.v ? out_->textures[id.v - 1].get() : nullptr;
  };
  in_.textures().each([&](uint32_t, const TextureDescription& t) { out_->textures.push_back(t.texture); });
  in_.materials().each([&](uint32_t id, const ups_material_desc& d) {
    Material m;
    m.model = MaterialModel(d.model);
    m.reflectance = to_rgb(d.reflectance_rgb);
    m.transmittance = to_rgb(d.transmittance_rgb);  // < 0: a clear pane; other models let nothing through
    if (m.transmittance.r < 0 && m.model != MaterialModel::glazing) m.transmittance = {};
    m.roughness = d.roughness, m.ior = d.ior, m.metallic = d.metallic;
    m.ior_rgb = to_rgb(d.ior_rgb), m.ior_k_rgb = to_rgb(d.ior_k_rgb);
    m.absorption_per_m = to_rgb(d.absorption_per_m_rgb);
    m.reflectance_texture = texture(d.reflectance_texture);
    m.roughness_texture = texture(d.roughness_texture);
    m.metallic_texture = texture(d.metallic_texture);
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
      warn("material " + std::to_string(id) + " emits light: its alpha is ignored, so its surface has no holes");
    }
    out_->texturing.push_back(t);
  });
  out_->material_used.resize(out_->materials.size());
}

void Builder::add_geometry() {
  in_.meshes().each([&](uint32_t, const std::shared_ptr<const Mesh>& mesh) { out_->meshes.push_back(mesh); });
  in_.instances().each([&](uint32_t id, const InstanceDescription& i) {
    instances_.push_back({i.mesh - 1, to_scene(i.to_world)});
    instance_ids_.push_back(id);
    out_->material_used[out_->meshes[i.mesh - 1]->material] = true;
  });
  out_->raytracer = std::make_unique<Raytracer>(out_->meshes, instances_, out_->texturing, threads_);
}

// ---- emitters ----

// Of the source that was begun last.
bool Builder::add_emitter(const std::string& name, std::unique_ptr<Emitter> emitter, const Vec3& probe) {
  if (!(emitter->flux_lm() > 0)) return false;
  // Beyond it illuminance near by, or its square, would leave the range of a float.
  if (!(emitter->flux_lm() <= 1e20)) fail_argument("emits more than 1e20 lm");
  emitters_.push_back(std::move(emitter));
  emitter_probes_.push_back(probe);
  out_->emitter_names.push_back(name);
  out_->source_of_emitter.push_back(uint32_t(out_->sources.size() - 1));
  return true;
}

void Builder::add_emissive_instances() {
  out_->emitter_of_instance.assign(instances_.size(), none);
  for (uint32_t i = 0; i < instances_.size(); ++i) {
    const Mesh& mesh = *out_->meshes[instances_[i].mesh];
    const ups_material_desc& material = in_.materials().get(mesh.material + 1, "material");
    const Rgb radiance = to_rgb(material.luminance_cd_m2);
    if (is_black(radiance)) continue;
    const Affine& m = instances_[i].to_scene;
    std::vector<Vec3> corners;
    for (const Vec3& p : mesh.positions) corners.push_back(Vec3(m.point(Vec3d(p))));
    const bool mirrored = m.determinant() < 0;
    std::vector<EmitterTriangle> triangles;
    for (size_t t = 0; t < mesh.indices.size(); t += 3) {
      EmitterTriangle triangle{corners[mesh.indices[t]], corners[mesh.indices[t + 1]], corners[mesh.indices[t + 2]]};
      if (mirrored) std::swap(triangle.p1, triangle.p2);  // keeps the front in front
      triangles.push_back(triangle);
    }
    const SurfacePoint s = out_->raytracer->surface_at(i, 0, 1 / 3.0f, 1 / 3.0f);
    const std::string name = "instance " + std::to_string(instance_ids_[i]);
    out_->sources.push_back({UPS_SOURCE_INSTANCE, instance_ids_[i], in_.instances().get(instance_ids_[i], "instance").group});
    const auto index = uint32_t(emitters_.size());
    const bool both_sides = material.emits_both_sides == 1;
    in_context(name, [&] {
      if (!add_emitter(name, std::make_unique<AreaEmitter>(std::move(triangles), radiance, both_sides, i),
                       s.ray_origin(s.ng)))
        return warn(name + " has a luminance but no area: it emits nothing");
      out_->emitter_of_instance[i] = index;
      ++out_->emissive_instance_count;
    });
  }
}

void Builder::add_sources() {
  in_.sources().each([&](uint32_t id, const SourceDescription& source) {
    const std::string name = "luminaire " + std::to_string(id);
    out_->sources.push_back({UPS_SOURCE_LUMINAIRE, id, source.group});
    in_context(name, [&] {
      if (const auto* light = std::get_if<LightDescription>(&source.kind))
        add_light(name, *light, source.dimming);
      else
        add_luminaire(name, std::get<LuminaireDescription>(source.kind), source.dimming);
    });
  });
}

void Builder::add_light(const std::string& name, const LightDescription& light, float dimming) {
  ++out_->light_count;
  const Rgb intensity = light.intensity * dimming;
  if (is_black(intensity)) return;
  const Vec3 axis = -Axes(light.to_world).frame().n;
  const Vec3 p = off_surface(*out_, to_scene(light.to_world.column(3)), axis);
  if (light.kind == UPS_LIGHT_POINT)
    add_emitter(name, std::make_unique<PointEmitter>(p, intensity, free_error(p)), p);
  else if (light.kind == UPS_LIGHT_SPOT)
    add_emitter(
        name, std::make_unique<SpotEmitter>(p, axis, intensity, light.inner_cone_rad, light.outer_cone_rad, free_error(p)),
        p);
  else {
    // Light paths start on a disc that covers the scene, and those of meters' discs that reach beyond it.
    const float radius = out_->radius > 0 ? out_->radius * (1 + largest_meter_disc) : 1.0f;
    add_emitter(name, std::make_unique<DirectionalEmitter>(axis, intensity, radius), axis * -out_->radius);
  }
}

void Builder::add_luminaire(const std::string& name, const LuminaireDescription& luminaire, float dimming) {
  ++out_->luminaire_count;
  for (const std::string& text : luminaire.profile->warnings) warn(name + ": " + text);
  const photometry::Opening& opening = luminaire.profile->opening;
  // A ray file's flux is that of its rays, and so is the interpolated one of their far field.
  const photometry::Distribution& far_field = luminaire.profile->distribution;
  const double file_flux =
      luminaire.profile->rays.empty() ? far_field.band_flux_lm() : far_field.interpolated_flux_lm();
  if (!(file_flux > 0)) return warn(name + ": its profile has no flux: it emits nothing");
  const double to_flux = luminaire.flux_lm >= 0 ? double(luminaire.flux_lm) / file_flux : 1;
  const Rgb scale = luminaire.color * float(double(dimming) * double(luminaire.intensity_scale) * to_flux);
  if (is_black(scale)) return;
  if (luminaire.use_opening && !luminaire.profile->rays.empty()) return add_rays(name, luminaire, scale);
  const std::shared_ptr<const photometry::Distribution> distribution(luminaire.profile,
                                                                     &luminaire.profile->distribution);
  const Frame frame = Axes(luminaire.to_world).frame();
  const Vec3 nadir = -frame.n, p = to_scene(luminaire.to_world.column(3));
  const bool has_area = LuminousBody::has_area(opening);
  if (!luminaire.use_opening || !has_area) {
    if (luminaire.use_opening && opening.shape != photometry::OpeningShape::point)
      warn(name + ": its opening has a single extent, so no area: it emits from a point");
    const Vec3 q = off_surface(*out_, p, nadir);
    add_emitter(name, std::make_unique<ProfilePointEmitter>(distribution, frame, q, scale, free_error(q)), q);
    return;
  }
  const float error = opening_error(p, frame, opening);
  auto emitter = std::make_unique<ProfileOpeningEmitter>(distribution, frame, p, opening, scale, error);
  // Where its rays start, and where walks run into it. A body is found by the ball around it (a disc without normal).
  const DiscIndex::Disc disc =
      emitter->is_flat()
          ? DiscIndex::Disc{p + emitter->normal() * (2 * error), emitter->normal(), emitter->circumscribed_radius()}
          : DiscIndex::Disc{p, Vec3(), emitter->circumscribed_radius() + 4 * error};
  const Vec3 front = emitter->is_flat() ? disc.center : p + nadir * (0.5f * opening.size_m[2] + 2 * error);
  const auto index = uint32_t(emitters_.size());
  if (!add_emitter(name, std::move(emitter), front)) return;
  openings_.push_back(disc);
  out_->emitter_of_opening.push_back(index);
}

// Of the opening's surface: a side of its box may lie on a surface of the scene.
float Builder::opening_error(const Vec3& p, const Frame& frame, const photometry::Opening& opening) const {
  const Vec3 half[3] = {frame.s * (0.5f * opening.size_m[0]), frame.t * (0.5f * opening.size_m[1]),
                        frame.n * (0.5f * opening.size_m[2])};
  const Vec3 axes[3] = {frame.s, frame.t, frame.n};
  float error = 0;
  for (int k = 0; k < 3; ++k) {
    const bool no_extent = !(opening.size_m[k] > 0),
               flat = !(opening.size_m[0] > 0 && opening.size_m[1] > 0 && opening.size_m[2] > 0);
    if (flat && !no_extent) continue;  // the edges of a sheet emit nothing
    for (const float side : {-1.0f, 1.0f})
      error =
          std::max(error, error_at(*out_, p + half[k] * side, axes[k] * side, half[(k + 1) % 3], half[(k + 2) % 3]));
  }
  return error;
}

// Null where the luminaire does not emit from rays.
std::shared_ptr<const RaySet> Builder::rays_of(const LuminaireDescription& luminaire) {
  if (!luminaire.use_opening || luminaire.profile->rays.empty()) return nullptr;
  std::shared_ptr<const RaySet>& set = ray_sets_[luminaire.profile.get()];
  if (!set) set = std::make_shared<RaySet>(luminaire.profile);
  return set;
}

void Builder::add_rays(const std::string& name, const LuminaireDescription& luminaire, const Rgb& scale) {
  const auto rays = rays_of(luminaire);
  warn(name + ": its light is the " + std::to_string(rays->size()) +
       " rays of a file, a sample with a noise of its own that no reported error contains: about 1 / sqrt(n) where n of "
       "them arrive, " +
       check::text(100 / std::sqrt(rays->effective_size())) + " % where all do");
  const Frame frame = Axes(luminaire.to_world).frame();
  auto emitter = std::make_unique<RayEmitter>(rays, frame, to_scene(luminaire.to_world.column(3)), scale);
  EmissionSample start;
  if (!emitter->sample_emission({0.5f, 0}, {}, start)) return;
  add_emitter(name, std::move(emitter), start.p + start.n * (2 * start.error));
}

// ---- sensors ----

MeterSet Builder::make_meters(const MetersDescription& in) const {
  MeterSet set;
  set.cell_width = in.cell_width, set.cell_height = in.cell_height;
  set.meters.resize(in.positions.size());
  parallel_for(threads_, in.positions.size(), [&](size_t i) {
    Meter& meter = set.meters[i];
    const Vec3d n = normalize(Vec3d(in.normals[i]));
    meter.p = to_scene(in.positions[i]);
    meter.frame = Frame(Vec3(n));
    if (!in.tangents.empty()) {
      const Vec3d t(in.tangents[i]), s = normalize(t - n * dot(t, n));
      meter.frame = {Vec3(s), Vec3(cross(n, s)), Vec3(n)};
    }
    const Vec3 half_a = meter.frame.s * (0.5f * set.cell_width), half_b = meter.frame.t * (0.5f * set.cell_height);
    meter.error = set.is_cell() ? error_at(*out_, meter.p, meter.frame.n, half_a, half_b)
                                : error_at(*out_, meter.p, meter.frame.n);
  });
  return set;
}

void Builder::add_sensors() {
  in_.sensors().each([&](uint32_t id, const Description::Sensor& s) {
    if (const auto* c = std::get_if<CameraDescription>(&s)) {
      out_->cameras.emplace_back(to_scene(c->to_world), c->width, c->height, c->vertical_fov_rad, c->illuminance);
      out_->camera_ids.push_back(id);
    } else if (const auto* g = std::get_if<GoniometerDescription>(&s)) {
      out_->goniometers.emplace_back(Axes(g->to_world).frame(), g->c_deg, g->gamma_deg, Goniometer::Symmetry(g->symmetry));
      out_->goniometer_openings.push_back(g->opening);
      out_->goniometer_ids.push_back(id);
    } else {
      out_->meter_sets.push_back(make_meters(std::get<MetersDescription>(s)));
      out_->meter_set_ids.push_back(id);
    }
  });
}

// ---- media ----

void Builder::find_media() {
  bool absorbs = false;
  for (size_t i = 0; i < out_->materials.size(); ++i)
    absorbs |= out_->material_used[i] && out_->materials[i].model == MaterialModel::glass &&
               !is_black(out_->materials[i].absorption_per_m);
  const auto find = [&](const Vec3& p) { return absorbs ? medium_at(*out_, p) : none; };
  for (const Camera& camera : out_->cameras) out_->medium_of_camera.push_back(find(camera.position()));
  for (const Vec3& p : emitter_probes_) out_->medium_of_emitter.push_back(find(p));
  for (const MeterSet& set : out_->meter_sets) {
    std::vector<uint32_t>& media = out_->medium_of_meter.emplace_back(set.meters.size(), none);
    if (!absorbs) continue;
    parallel_for(threads_, set.meters.size(), [&](size_t i) {
      const Meter& meter = set.meters[i];
      media[i] = find(meter.p + meter.frame.n * (2 * meter.error));
    });
  }
}

// ---- warnings ----

void Builder::add_warnings() {
  const Duplicates duplicates = find_duplicates(out_->meshes, instances_);
  if (duplicates.count > 0) {
    const auto name = [&](const Duplicates::Triangle& t) {
      return "triangle " + std::to_string(t.primitive) + " of instance " + std::to_string(instance_ids_[t.instance]);
    };
    warn(std::to_string(duplicates.count) + (duplicates.count == 1 ? " triangle lies" : " triangles lie") +
         " exactly on another, such as " + name(duplicates.second) + " on " + name(duplicates.first) +
         ": rounding decides which of them a ray hits");
  }
  if (out_->emitters.size() == 0) warn("nothing in the scene emits light");
  if (out_->cameras.empty() && out_->meter_sets.empty() && out_->goniometers.empty())
    warn("the scene has no camera, no meters and no goniometer: there is nothing to measure");
  for (size_t i = 0; !out_->goniometers.empty() && i < out_->emitters.size(); ++i)
    if (out_->emitters[i].is_directional())
      warn(out_->emitter_names[i] + " shines in parallel: where that light leaves the scene, a goniometer's intensity " +
           "depends on its grid, as it would be infinite");
}

}  // namespace

std::shared_ptr<const Snapshot> prepare(const Description& description, int thread_count) {
  return Builder(description, thread_count).build();
}

}  // namespace ups
