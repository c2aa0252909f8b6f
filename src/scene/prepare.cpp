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
#include "scene/flat_mirrors.h"
#include "scene/searched.h"

namespace ups {

std::shared_ptr<const Snapshot> Builder::build() {
  out_->tag = in_.tag();
  out_->described = std::make_shared<const Description>(in_);
  out_->maintenance_factor = in_.maintenance_factor();
  list_surfaces();
  place();
  add_materials();
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
  out_->flat_mirrors = find_flat_mirrors(*out_);
  out_->effects = find_effects(*out_);
  find_concentration();
  monitor_.begin_part(1);
  share_searches();
  add_warnings();
  return out_;
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
        if (surface) return make_surface_meters(id, *surface);
        MeterSet set = make_meters(std::get<MetersDescription>(s));
        note_glass_edges(id, set);
        return set;
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

// What nothing has changed for is not searched again.
void Builder::share_searches() {
  const auto same_material = [](const auto& a, const auto& b) { return a.material == b.material; };
  const bool look_alike = same_surfaces_ && earlier_->emitter_of_instance == out_->emitter_of_instance &&
                          std::ranges::equal(earlier_->instances, out_->instances, same_material);
  out_->surface_search = look_alike ? earlier_->surface_search : std::make_shared<SearchedWarnings>();
  out_->light_search = same_places_ && same_emitters_ && sensors_are_same() ? earlier_->light_search
                                                                            : std::make_shared<SearchedWarnings>();
}

std::shared_ptr<const Snapshot> prepare(const Description& description, ThreadPool& pool,
                                        const std::shared_ptr<const Snapshot>& earlier, Monitor* monitor) {
  Monitor nobody;
  auto scene = Builder(description, pool, earlier.get(), monitor ? *monitor : nobody).build();
  if (!earlier) searched_warnings(*scene, pool, monitor);
  return scene;
}

}  // namespace ups
