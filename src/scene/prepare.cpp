// See prepare.h. The steps in order: surfaces' list, place, materials, geometry, emitters, sensors, media, effects and
// warnings.
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
  list_surfaces();
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
  for (const Raytracer::Instance& i : out_->instances)
    for (int k = 0; k < 8; ++k)
      grow(i.to_scene.point(out_->mesh_boxes[i.mesh].corner(k)), "instance", i.number);  // its origin is the world's yet
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
