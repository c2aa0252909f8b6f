// See builder.h: emissive surfaces, lights, luminaires with their openings or rays.
#include <algorithm>
#include <limits>

#include "base/parallel.h"
#include "bsdf/material.h"
#include "emitter/area.h"
#include "emitter/point.h"
#include "emitter/profile.h"
#include "photometry/metrics.h"
#include "scene/builder.h"
#include "scene/check.h"
#include "scene/footing.h"
#include "scene/length_text.h"
#include "scene/probe.h"

namespace ups {
namespace {

float smallest_extent(const photometry::Opening& opening) {
  float smallest = 0;
  for (const float size : opening.size_m)
    if (size > 0) smallest = smallest > 0 ? std::min(smallest, size) : size;
  return smallest;
}

// By how much the axes miss right angles, degrees: a shear, as of a scale of axes that were turned before. A table of
// intensities has no such form.
double shear_deg(const Affine& m) {
  const Vec3d x = normalize(m.column(0)), y = normalize(m.column(1)), z = normalize(m.column(2));
  const double cosine = std::max({std::abs(dot(x, y)), std::abs(dot(y, z)), std::abs(dot(z, x))});
  return std::asin(std::min(1.0, cosine)) * (180 / double(pi));
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

// At the same place and of the same shape, whatever its flux, colour and group.
bool stands_as(const SourceDescription& a, const SourceDescription& b) {
  if (a.kind.index() != b.kind.index()) return false;
  if (const auto* light = std::get_if<LightDescription>(&a.kind)) {
    const auto& other = std::get<LightDescription>(b.kind);
    return light->kind == other.kind && light->to_world == other.to_world &&
           light->inner_cone_rad == other.inner_cone_rad && light->outer_cone_rad == other.outer_cone_rad;
  }
  const auto &one = std::get<LuminaireDescription>(a.kind), &other = std::get<LuminaireDescription>(b.kind);
  return one.profile == other.profile && one.use_opening == other.use_opening && one.to_world == other.to_world;
}

// None that is all mirror or clear glass, here or there.
bool all_surfaces_scatter(const Snapshot& scene) {
  for (const Material& material : scene.materials) {
    const bool uniform = !material.roughness_texture && !material.metallic_texture && !material.reflectance_texture;
    if (!uniform || !Bsdf(material, {}).has_continuous()) return false;
  }
  return true;
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

[[noreturn]] void fail_too_bright() { fail_argument("emits more than 1e20 lm"); }

double area_m2(const Mesh& mesh, const Affine& to_scene) {
  const auto corner = [&](size_t i) { return to_scene.point(Vec3d(mesh.positions[mesh.indices[i]])); };
  double sum = 0;
  for (size_t t = 0; t < mesh.indices.size(); t += 3)
    sum += 0.5 * length(cross(corner(t + 1) - corner(t), corner(t + 2) - corner(t)));
  return sum;
}

}  // namespace

std::vector<EmitterTriangle> emitting_triangles(const Mesh& mesh, const Affine& to_scene) {
  const bool mirrored = to_scene.determinant() < 0;
  const auto corner = [&](size_t i) { return Vec3(to_scene.point(Vec3d(mesh.positions[mesh.indices[i]]))); };
  std::vector<EmitterTriangle> triangles;
  triangles.reserve(mesh.triangle_count());
  for (size_t t = 0; t < mesh.indices.size(); t += 3) {
    EmitterTriangle triangle{corner(t), corner(t + 1), corner(t + 2)};
    if (mirrored) std::swap(triangle.p1, triangle.p2);  // keeps the front in front
    triangles.push_back(triangle);
  }
  return triangles;
}

void Builder::bound(Source& source, const Mesh& mesh, const Affine& to_scene) const {
  Box box;
  mesh.each_used([&](const Vec3& p) { box.grow(Vec3d(Vec3(to_scene.point(Vec3d(p)))) + out_->origin); });
  source.bounds_min = box.lower, source.bounds_max = box.upper;
}

// Of the source that was begun last.
bool Builder::add_emitter(const std::string& name, std::shared_ptr<const Emitter> emitter, UnitEmitter unit,
                          const Vec3& front, const EmitterProbe& probe, float size) {
  if (emitter->flux_lm() <= 0) return false;
  // Beyond it illuminance near by, or its square, would leave the range of a float; infinity, of a colour with a zero,
  // gives no number.
  if (!(emitter->flux_lm() <= 1e20)) fail_too_bright();
  emitters_.push_back(std::move(emitter));
  unit_emitters_.push_back(std::move(unit));
  emitter_fronts_.push_back(front);
  out_->emitter_probes.push_back(probe);
  out_->emitter_names.push_back(name);
  out_->emitter_sizes.push_back(size);
  out_->source_of_emitter.push_back(uint32_t(out_->sources.size() - 1));
  return true;
}

void Builder::add_emissive_instances() {
  const std::vector<Raytracer::Instance>& instances = out_->instances;
  for (size_t e = 0; earlier_ && e < earlier_->emitters.size(); ++e) {
    const Source& source = earlier_->sources[earlier_->source_of_emitter[e]];
    earlier_emitter_[{source.kind, source.id}] = e;
  }
  same_emitters_ = same_places_;
  out_->emitter_of_instance.assign(instances.size(), none);
  for (uint32_t i = 0; i < instances.size(); ++i) {
    const Mesh& mesh = *out_->meshes[instances[i].mesh];
    const ups_material_desc& material = in_.materials().at(out_->material_numbers[instances[i].material]);
    const InstanceDescription& described = in_.instances().at(out_->instance_ids[i]);
    const Rgb radiance = to_rgb(material.luminance_cd_m2) *
                         (described.of_fixture ? float(in_.maintenance_factor()) : 1.0f);
    const auto add_source = [&] {
      out_->sources.push_back({UPS_SOURCE_INSTANCE, out_->instance_ids[i], described.group, -1, described.to_world});
      out_->sources.back().of_fixture = described.of_fixture;
      bound(out_->sources.back(), mesh, instances[i].to_scene);
    };
    if (is_black(radiance)) {
      if (described.emits) add_source();
      continue;
    }
    if (mesh.revolution)
      fail_argument("instance " + std::to_string(out_->instance_ids[i]) + ": its material has a luminance, and it is the " +
                    "curved part of a fixture, whose triangles rays do not meet; its light would be that of an emitter of " +
                    "the fixture, ups_fixture_add_emitter");
    unmaintained_ += !described.of_fixture;
    const bool both_sides = material.emits_both_sides == 1;
    const auto known = is_same_instance(i) ? earlier_emitter_.find({UPS_SOURCE_INSTANCE, out_->instance_ids[i]})
                                           : earlier_emitter_.end();
    std::shared_ptr<AreaEmitter> emitter;
    EmitterProbe probe;
    if (known == earlier_emitter_.end()) {
      emitter = std::make_shared<AreaEmitter>(emitting_triangles(mesh, instances[i].to_scene), radiance, both_sides, i);
      same_emitters_ = false;
    } else {
      const auto& as_before = static_cast<const AreaEmitter&>(earlier_->emitters[known->second]);
      emitter = std::make_shared<AreaEmitter>(as_before, radiance, both_sides);
      const bool shines_as_before = same_places_ && as_before.emits_both_sides() == both_sides;
      if (shines_as_before) probe = earlier_->emitter_probes[known->second];
      same_emitters_ = same_emitters_ && shines_as_before;
    }
    // The flux of a fixture's emitter is given: far from the origin, floats make a small one's area larger or smaller.
    if (described.of_fixture && emitter->area() > 0)
      emitter->set_radiance(radiance * float(area_m2(mesh, instances[i].to_scene) / emitter->area()));
    const SurfacePoint s = out_->raytracer->surface_at(i, 0, 1 / 3.0f, 1 / 3.0f);
    emitter->set_least_error(s.error);
    const std::string name = "instance " + std::to_string(out_->instance_ids[i]);
    add_source();
    if (probe.lies_in_another < 0) {
      probe.lies_in_another = both_sides && lies_in_another(*out_, *emitter, i);
      probe.starts_beyond = both_sides ? none : starts_beyond(*out_, *emitter, i);
    }
    const auto index = uint32_t(emitters_.size());
    const UnitEmitter unit = [emitter, both_sides] {
      return std::make_unique<AreaEmitter>(*emitter, Rgb(1), both_sides);
    };
    in_context(name, [&] {
      if (!add_emitter(name, emitter, unit, s.ray_origin(s.ng), probe))
        return warn_of(out_->sources.back(), "a luminance but no area: nothing is emitted");
      if (probe.lies_in_another == 1)
        warn_of(out_->sources.back(),
                "it emits to both sides, and lies in the plane of another surface, which some of the rays to it meet "
                "first: up to a third of its light is lost; move it off that surface");
      if (probe.starts_beyond != none)
        warn_of(out_->sources.back(),
                "instance " + std::to_string(out_->instance_ids[probe.starts_beyond]) +
                    " lies on it, or closer to it than single precision tells apart: light that should meet that "
                    "starts behind it; move them apart");
      contact_of_source();
      out_->emitter_of_instance[i] = index;
      ++out_->emissive_instance_count;
    });
  }
}

void Builder::add_sources() {
  in_.sources().each([&](uint32_t id, const SourceDescription& source) {
    monitor_.check();
    const std::string name = "luminaire " + std::to_string(id);
    out_->sources.push_back(source_of(source, id));
    in_context(name, [&] {
      if (const auto* light = std::get_if<LightDescription>(&source.kind))
        add_light(name, *light, source);
      else
        add_luminaire(name, std::get<LuminaireDescription>(source.kind), source);
    });
  });
  same_emitters_ = same_emitters_ && earlier_->emitter_names == out_->emitter_names;
}

const EmitterProbe* Builder::known_probe(const SourceDescription& source) const {
  const uint32_t id = out_->sources.back().id;
  const auto known = earlier_emitter_.find({UPS_SOURCE_LUMINAIRE, id});
  if (!same_places_ || known == earlier_emitter_.end()) return nullptr;
  // Rays of a directional light start on a disc about the scene's centre.
  const auto* light = std::get_if<LightDescription>(&source.kind);
  if (light && light->kind == UPS_LIGHT_DIRECTIONAL && length2(earlier_->centre - out_->centre) > 0) return nullptr;
  return stands_as(source, earlier_->described->sources().at(id)) ? &earlier_->emitter_probes[known->second] : nullptr;
}

EmitterProbe Builder::probe_of(const SourceDescription& source, const std::function<EmitterProbe()>& find) {
  const EmitterProbe* known = known_probe(source);
  same_emitters_ = same_emitters_ && known;
  return known ? *known : find();
}

// Of a source without extent at p.
EmitterProbe Builder::place_probe(const SourceDescription& source, const Vec3& p, const PlacedEmitter& make_at) {
  const EmitterProbe probe = probe_of(source, [&] {
    const SourcePlace found = off_surfaces(*out_, p, *make_at(Vec3(), Rgb(1)));
    EmitterProbe out;
    out.place = found.p, out.into_surface = found.into_surface;
    return out;
  });
  constexpr float told = 0.1f;  // less is what a luminaire on a ceiling sends upwards
  if (probe.into_surface > told)
    warn_of(out_->sources.back(), "it lies on a surface, into which goes " +
                                      std::to_string(std::lround(100 * probe.into_surface)) +
                                      " % of its light: move it off the surface");
  return probe;
}

// Of those for which it makes a difference. Where every surface that light meets has a lobe that next-event estimation
// can pick it up from, it is all of it.
void Builder::find_exposed() {
  std::vector<float> exposed;
  if (EmitterSet::uses_exposed(emitters_.size())) {
    const bool all = all_surfaces_scatter(*out_);
    parallel_for(threads_, emitters_.size(), [&](size_t e) {
      float& share = out_->emitter_probes[e].exposed;
      if (all)
        share = 1;
      else if (share < 0)
        share = exposed_share(*out_, *unit_emitters_[e]());
    });
    for (const EmitterProbe& probe : out_->emitter_probes) exposed.push_back(probe.exposed);
  }
  out_->emitters = EmitterSet(std::move(emitters_), exposed);
}

void Builder::add_light(const std::string& name, const LightDescription& light, const SourceDescription& source) {
  ++out_->light_count;
  unmaintained_ += light.kind != UPS_LIGHT_DIRECTIONAL;
  const Rgb intensity = light.intensity * source.dimming;
  if (is_black(intensity)) return;
  const Vec3 axis = -Axes(light.to_world).frame().n;
  // Light paths start on a disc that covers the scene, and those of meters' discs that reach beyond it.
  const float radius = out_->radius > 0 ? out_->radius * (1 + largest_meter_disc) : 1.0f;
  const bool has_place = light.kind != UPS_LIGHT_DIRECTIONAL;  // wherever it says it is
  const Vec3 p = has_place ? to_scene(light.to_world.column(3)) : Vec3();
  const auto make_at = [=, centre = out_->centre](const Vec3& shift, const Rgb& of) -> std::unique_ptr<Emitter> {
    if (light.kind == UPS_LIGHT_POINT) return std::make_unique<PointEmitter>(p, of, free_error(p), shift);
    if (light.kind == UPS_LIGHT_SPOT)
      return std::make_unique<SpotEmitter>(p, axis, of, light.inner_cone_rad, light.outer_cone_rad, free_error(p),
                                           shift);
    return std::make_unique<DirectionalEmitter>(axis, of, radius, centre);
  };
  const EmitterProbe probe =
      has_place ? place_probe(source, p, make_at) : probe_of(source, [] { return EmitterProbe(); });
  const auto make = [=, shift = probe.place - p](const Rgb& of) { return make_at(shift, of); };
  const Vec3 front = light.kind == UPS_LIGHT_DIRECTIONAL ? out_->centre - axis * out_->radius : probe.place;
  add_emitter(name, make(intensity), [make] { return make(Rgb(1)); }, front, probe);
}

void Builder::add_luminaire(const std::string& name, const LuminaireDescription& luminaire,
                            const SourceDescription& source) {
  ++out_->luminaire_count;
  for (const std::string& text : luminaire.profile->warnings) warn_of(out_->sources.back(), text);
  constexpr double least_shear_deg = 0.1;
  if (const double shear = shear_deg(luminaire.to_world); shear > least_shear_deg)
    warn_of(out_->sources.back(),
            "to_world is sheared, its axes are " + short_text(shear) +
                " degrees off right angles: the light is aimed by its z and turned by its x alone");
  const photometry::Opening& opening = luminaire.profile->opening;
  const double file_flux = photometry::flux_lm(*luminaire.profile);
  if (!(file_flux > 0)) return warn_of(out_->sources.back(), "the profile has no flux: nothing is emitted");
  const double to_flux = luminaire.flux_lm >= 0 ? double(luminaire.flux_lm) / file_flux : 1;
  const double factor = double(source.dimming) * double(luminaire.intensity_scale) * to_flux * in_.maintenance_factor(),
               brightest = double(max_component(luminaire.color)) * factor * std::max(1.0, file_flux);
  if (!(brightest <= double(std::numeric_limits<float>::max()))) fail_too_bright();  // as add_emitter does, in floats
  const Rgb scale = luminaire.color * float(factor);
  if (is_black(scale)) return;
  if (luminaire.use_opening && !luminaire.profile->rays.empty()) return add_rays(name, luminaire, source, scale);
  const std::shared_ptr<const photometry::Distribution> distribution(luminaire.profile,
                                                                     &luminaire.profile->distribution);
  const Frame frame = Axes(luminaire.to_world).frame();
  const Vec3 nadir = -frame.n, p = place_of(luminaire);
  const bool has_area = LuminousBody::has_area(opening);
  const float size = smallest_extent(opening);
  if (!luminaire.use_opening || !has_area) {
    if (luminaire.use_opening && opening.shape != photometry::OpeningShape::point)
      warn_of(out_->sources.back(), "the opening has a single extent, so no area: light comes from a point");
    const auto make_at = [=](const Vec3& shift, const Rgb& of) {
      return std::make_unique<ProfilePointEmitter>(distribution, frame, p, of, free_error(p), shift);
    };
    const EmitterProbe probe = place_probe(source, p, make_at);
    const auto make = [=, shift = probe.place - p](const Rgb& of) { return make_at(shift, of); };
    add_emitter(name, make(scale), [make] { return make(Rgb(1)); }, probe.place, probe, size);
    return;
  }
  const auto make_at = [=, opening = opening](const Vec3& at, const Rgb& of, float error) {
    return std::make_unique<ProfileOpeningEmitter>(distribution, frame, at, opening, of, error);
  };
  const EmitterProbe probe = probe_of(source, [&] {
    EmitterProbe found;
    found.error = opening_error(p, frame, opening);
    found.place = opening_place(p, frame, opening, found.error, *make_at(p, Rgb(1), found.error));
    return found;
  });
  const float error = probe.error;
  const Vec3 at = probe.place;
  const auto make = [=](const Rgb& of) { return make_at(at, of, error); };
  auto emitter = make(scale);
  // Where its rays start, and where walks run into it. A body is found by the ball around it (a disc without normal).
  const DiscIndex::Disc disc =
      emitter->is_flat()
          ? DiscIndex::Disc{at + emitter->normal() * (2 * error), emitter->normal(), emitter->circumscribed_radius()}
          : DiscIndex::Disc{at, Vec3(), emitter->circumscribed_radius() + 4 * error};
  const Vec3 front = emitter->is_flat() ? disc.center : at + nadir * (0.5f * opening.size_m[2] + 2 * error);
  const auto index = uint32_t(emitters_.size());
  if (!add_emitter(name, std::move(emitter), [make] { return make(Rgb(1)); }, front, probe, size)) return;
  openings_.push_back(disc);
  out_->emitter_of_opening.push_back(index);
}

Vec3 Builder::place_of(const LuminaireDescription& luminaire) {
  const Contact* contact = contact_of_source();
  return to_scene(luminaire.to_world.column(3) + (contact && contact->is_moved() ? contact->shift : Vec3d()));
}

// An opening of which a face lies on an opaque surface, as under a ceiling, is moved off it by more than its rays start
// off its faces (of a body 8 errors along their own line at most, emission_origin) and than shadow rays are shortened:
// else what it sends there would start behind it. A body whose light belongs there stays: it starts beyond.
Vec3 Builder::opening_place(const Vec3& p, const Frame& frame, const photometry::Opening& opening, float error,
                            const ProfileOpeningEmitter& emitter) const {
  const Vec3 axes[3] = {frame.s, frame.t, frame.n};
  const bool flat = emitter.is_flat();
  const float lift = std::max((flat ? 4 : 12) * error, least_source_lift(*out_));
  Vec3 moved = p;
  for (int k = 0; k < 3; ++k) {
    if (flat && opening.size_m[k] > 0) continue;
    const auto half = [&](int axis) { return axes[axis % 3] * (0.5f * opening.size_m[axis % 3]); };
    const auto lies = [&](float side) {
      return lies_on_opaque(*out_, p + half(k) * side, axes[k] * side, half(k + 1), half(k + 2));
    };
    const bool above = lies(1), below = lies(-1);
    if (flat ? !(above || below) : above == below) continue;
    const Vec3 away = flat ? emitter.normal() : above ? -axes[k] : axes[k], to_face = flat ? Vec3() : half(k);
    const Vec3 face = above ? p + to_face : p - to_face, opposite = above ? p - to_face : p + to_face;
    if (flat || !shines_behind(*out_, emitter, face, away, 2 * error))
      moved = moved + away * room_for(*out_, opposite, away, 2 * error, lift);
  }
  return moved;
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

void Builder::add_rays(const std::string& name, const LuminaireDescription& luminaire, const SourceDescription& source,
                       const Rgb& scale) {
  const auto rays = rays_of(luminaire);
  warn_of(out_->sources.back(),
          "the light is the " + std::to_string(rays->size()) + " rays of a file, a sample with a noise of its own that " +
              (rays->is_shared() ? "is part of the errors of meters, however long they are rendered"
                                 : "no reported error contains") +
              ": about 1 / sqrt(n) where n of them arrive, " + check::text(100 / std::sqrt(rays->effective_size())) +
              " % where all do");
  const Frame frame = Axes(luminaire.to_world).frame();
  const Vec3 p = place_of(luminaire);
  const auto make = [=](const Rgb& of) { return std::make_unique<RayEmitter>(rays, frame, p, of); };
  auto emitter = make(scale);
  EmissionSample start;
  if (!emitter->sample_emission({0.5f, 0}, {}, start)) return;
  add_emitter(name, std::move(emitter), [make] { return make(Rgb(1)); }, start.p + start.n * (2 * start.error),
              probe_of(source, [] { return EmitterProbe{}; }));
}

// Read where it decides, see render/method.h: where eye paths reach all light, and nothing but flat mirrors focuses it.
void Builder::find_concentration() {
  if (out_->effects.path_tracing_complete && (!out_->effects.sharp_caster || out_->flat_mirrors.complete))
    out_->effects.concentration = first_light_concentration(*out_, out_->emitter_probes, threads_);
}

}  // namespace ups
