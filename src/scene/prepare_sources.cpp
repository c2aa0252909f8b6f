// See builder.h: emissive surfaces, lights, luminaires with their openings or rays.
#include <algorithm>

#include "base/parallel.h"
#include "emitter/area.h"
#include "emitter/point.h"
#include "emitter/profile.h"
#include "photometry/metrics.h"
#include "scene/builder.h"
#include "scene/check.h"
#include "scene/probe.h"

namespace ups {
namespace {

float smallest_extent(const photometry::Opening& opening) {
  float smallest = 0;
  for (const float size : opening.size_m)
    if (size > 0) smallest = smallest > 0 ? std::min(smallest, size) : size;
  return smallest;
}

Vec3d opening_reach(const LuminaireDescription& luminaire) {
  const photometry::Opening& opening = luminaire.profile->opening;
  if (!luminaire.use_opening || !LuminousBody::has_area(opening)) return {};
  const Frame frame = Axes(luminaire.to_world).frame();
  const auto half = [&](int k) {
    return 0.5 * (double(std::abs(frame.s[k])) * double(opening.size_m[0]) +
                  double(std::abs(frame.t[k])) * double(opening.size_m[1]) +
                  double(std::abs(frame.n[k])) * double(opening.size_m[2]));
  };
  return {half(0), half(1), half(2)};
}

Source source_of(const SourceDescription& from, uint32_t id) {
  Source source{UPS_SOURCE_LUMINAIRE, id, from.group};
  Vec3d reach;
  if (const auto* light = std::get_if<LightDescription>(&from.kind)) {
    source.light_kind = light->kind;
    source.to_world = light->to_world;
  } else {
    const auto& luminaire = std::get<LuminaireDescription>(from.kind);
    source.to_world = luminaire.to_world;
    source.profile = luminaire.profile;
    reach = opening_reach(luminaire);
  }
  source.bounds_min = source.to_world.column(3) - reach;
  source.bounds_max = source.to_world.column(3) + reach;
  return source;
}

}  // namespace

// corners: in the scene's frame.
void Builder::bound(Source& source, const std::vector<Vec3>& corners) const {
  for (size_t i = 0; i < corners.size(); ++i) {
    const Vec3d p = Vec3d(corners[i]) + out_->origin;
    Vec3d &low = source.bounds_min, &high = source.bounds_max;
    low = i == 0 ? p : Vec3d(std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z));
    high = i == 0 ? p : Vec3d(std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z));
  }
}

// Of the source that was begun last.
bool Builder::add_emitter(const std::string& name, std::unique_ptr<Emitter> emitter, const Vec3& probe, float size) {
  if (!(emitter->flux_lm() > 0)) return false;
  // Beyond it illuminance near by, or its square, would leave the range of a float.
  if (!(emitter->flux_lm() <= 1e20)) fail_argument("emits more than 1e20 lm");
  emitters_.push_back(std::move(emitter));
  emitter_probes_.push_back(probe);
  out_->emitter_names.push_back(name);
  out_->emitter_sizes.push_back(size);
  out_->source_of_emitter.push_back(uint32_t(out_->sources.size() - 1));
  return true;
}

void Builder::add_emissive_instances() {
  out_->emitter_of_instance.assign(instances_.size(), none);
  for (uint32_t i = 0; i < instances_.size(); ++i) {
    const Mesh& mesh = *out_->meshes[instances_[i].mesh];
    const ups_material_desc& material = in_.materials().at(mesh.material + 1);
    const InstanceDescription& described = in_.instances().at(out_->instance_ids[i]);
    const Rgb radiance = to_rgb(material.luminance_cd_m2) *
                         (described.of_fixture ? float(in_.maintenance_factor()) : 1.0f);
    if (is_black(radiance)) continue;
    unmaintained_ += !described.of_fixture;
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
    const std::string name = "instance " + std::to_string(out_->instance_ids[i]);
    out_->sources.push_back({UPS_SOURCE_INSTANCE, out_->instance_ids[i], described.group, -1, described.to_world});
    out_->sources.back().of_fixture = described.of_fixture;
    bound(out_->sources.back(), corners);
    const auto index = uint32_t(emitters_.size());
    const bool both_sides = material.emits_both_sides == 1;
    in_context(name, [&] {
      if (!add_emitter(name, std::make_unique<AreaEmitter>(std::move(triangles), radiance, both_sides, i),
                       s.ray_origin(s.ng)))
        return warn_of(out_->sources.back(), "a luminance but no area: nothing is emitted");
      out_->emitter_of_instance[i] = index;
      ++out_->emissive_instance_count;
    });
  }
}

void Builder::add_sources() {
  in_.sources().each([&](uint32_t id, const SourceDescription& source) {
    const std::string name = "luminaire " + std::to_string(id);
    out_->sources.push_back(source_of(source, id));
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
  unmaintained_ += light.kind != UPS_LIGHT_DIRECTIONAL;
  const Rgb intensity = light.intensity * dimming;
  if (is_black(intensity)) return;
  const Vec3 axis = -Axes(light.to_world).frame().n;
  const Vec3 p = off_surface(*out_, to_scene(light.to_world.column(3)), axis);
  if (light.kind == UPS_LIGHT_POINT)
    add_emitter(name, std::make_unique<PointEmitter>(p, intensity, free_error(p)), p);
  else if (light.kind == UPS_LIGHT_SPOT)
    add_emitter(
        name,
        std::make_unique<SpotEmitter>(p, axis, intensity, light.inner_cone_rad, light.outer_cone_rad, free_error(p)),
        p);
  else {
    // Light paths start on a disc that covers the scene, and those of meters' discs that reach beyond it.
    const float radius = out_->radius > 0 ? out_->radius * (1 + largest_meter_disc) : 1.0f;
    add_emitter(name, std::make_unique<DirectionalEmitter>(axis, intensity, radius), axis * -out_->radius);
  }
}

void Builder::add_luminaire(const std::string& name, const LuminaireDescription& luminaire, float dimming) {
  ++out_->luminaire_count;
  for (const std::string& text : luminaire.profile->warnings) warn_of(out_->sources.back(), text);
  const photometry::Opening& opening = luminaire.profile->opening;
  const double file_flux = photometry::flux_lm(*luminaire.profile);
  if (!(file_flux > 0)) return warn_of(out_->sources.back(), "the profile has no flux: nothing is emitted");
  const double to_flux = luminaire.flux_lm >= 0 ? double(luminaire.flux_lm) / file_flux : 1;
  const Rgb scale = luminaire.color * float(double(dimming) * double(luminaire.intensity_scale) * to_flux *
                                            in_.maintenance_factor());
  if (is_black(scale)) return;
  if (luminaire.use_opening && !luminaire.profile->rays.empty()) return add_rays(name, luminaire, scale);
  const std::shared_ptr<const photometry::Distribution> distribution(luminaire.profile,
                                                                     &luminaire.profile->distribution);
  const Frame frame = Axes(luminaire.to_world).frame();
  const Vec3 nadir = -frame.n, p = to_scene(luminaire.to_world.column(3));
  const bool has_area = LuminousBody::has_area(opening);
  const float size = smallest_extent(opening);
  if (!luminaire.use_opening || !has_area) {
    if (luminaire.use_opening && opening.shape != photometry::OpeningShape::point)
      warn_of(out_->sources.back(), "the opening has a single extent, so no area: light comes from a point");
    const Vec3 q = off_surface(*out_, p, nadir);
    add_emitter(name, std::make_unique<ProfilePointEmitter>(distribution, frame, q, scale, free_error(q)), q, size);
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
  if (!add_emitter(name, std::move(emitter), front, size)) return;
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
  warn_of(out_->sources.back(),
          "the light is the " + std::to_string(rays->size()) +
              " rays of a file, a sample with a noise of its own that no reported error contains: about 1 / sqrt(n) " +
              "where n of them arrive, " + check::text(100 / std::sqrt(rays->effective_size())) + " % where all do");
  const Frame frame = Axes(luminaire.to_world).frame();
  auto emitter = std::make_unique<RayEmitter>(rays, frame, to_scene(luminaire.to_world.column(3)), scale);
  EmissionSample start;
  if (!emitter->sample_emission({0.5f, 0}, {}, start)) return;
  add_emitter(name, std::move(emitter), start.p + start.n * (2 * start.error));
}

}  // namespace ups
