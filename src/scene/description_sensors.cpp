// See description.h: cameras, meters, goniometers and observers.
#include <cmath>
#include <set>

#include "scene/description.h"
#include "scene/read.h"
#include "sensor/goniometer.h"

namespace ups {
namespace {

constexpr uint32_t max_meters = 16'777'216;  // of a set

}  // namespace

Description::Sensor Description::read(const ups_camera_desc& d) const {
  check::enumeration(d.projection, UPS_PANORAMA, "projection",
                     "UPS_PERSPECTIVE, UPS_EQUIDISTANT, UPS_EQUISOLID, UPS_PANORAMA");
  check_count(d.width, 1, 16384, "width");
  check_count(d.height, 1, 16384, "height");
  check::transform(d.to_world, "to_world");
  check::require(
      d.projection != UPS_PERSPECTIVE || (std::isfinite(d.vertical_fov_rad) && d.vertical_fov_rad >= 1e-6f &&
                                          double(d.vertical_fov_rad) < 3.14159265358979),
      "vertical_fov_rad is " + check::text(double(d.vertical_fov_rad)) + "; it must be at least 1e-6 and below pi");
  check::flag(d.illuminance, "illuminance");
  constexpr uint32_t all = UPS_LAYER_ALBEDO | UPS_LAYER_NORMAL | UPS_LAYER_DEPTH | UPS_LAYER_ID;
  check::require((d.layers & ~all) == 0,
                 "layers is " + std::to_string(d.layers) + "; it must be UPS_LAYER_* joined by |, at most " +
                     std::to_string(all));
  check_reserved(d.reserved);
  return CameraDescription{to_affine(d.to_world), d.width,      d.height, d.vertical_fov_rad,
                           d.illuminance == 1,    d.projection, d.layers};
}

Description::Sensor Description::read(const ups_meter_desc& d) const {
  check::enumeration(d.kind, UPS_METER_VECTOR, "kind", "UPS_METER_*");
  check_count(d.count, 1, max_meters, "count");
  check_reserved(d.reserved);
  check::pointer(d.positions_m, "positions_m");
  check::pointer(d.normals, "normals");
  const float width = d.cell_size_m[0], height = d.cell_size_m[1];
  constexpr float least_size = 1e-9f;  // of smaller ones the light per area is beyond a float
  const bool cells = width >= least_size && height >= least_size && std::isfinite(width) && std::isfinite(height);
  check::require(cells || (width == 0 && height == 0), "cell_size_m is " + check::text(double(width)) + ", " +
                                                           check::text(double(height)) +
                                                           "; it must be 0, 0 (points) or both at least 1e-9");
  if (cells) check::pointer(d.tangents, "tangents");
  check::at_least(double(d.footprint_m), 0, "footprint_m");
  check::require(d.footprint_m == 0 || d.footprint_m >= least_size,
                 "footprint_m is " + check::text(double(d.footprint_m)) + "; it must be 0 (points) or at least 1e-9");
  check::require(!(cells && d.footprint_m > 0),
                 "footprint_m is " + check::text(double(d.footprint_m)) +
                     " beside cell_size_m; a mean is over a disc or a rectangle: leave one of them 0");
  check_reserved(d.reserved_2, "reserved_2");
  for (size_t i = 0; i < d.count; ++i)
    for (size_t k = 0; k < 3; ++k)
      if (!std::isfinite(d.positions_m[3 * i + k]))
        fail_argument("positions_m: element " + std::to_string(i) + ", component " + std::to_string(k) + " is " +
                      check::text(d.positions_m[3 * i + k]) + "; it must be finite");
  const check::Floats normals{d.normals, d.count, 3, 0}, tangents{d.tangents, d.tangents ? d.count : 0, 3, 0};
  check::all_finite(normals, "normals", "");
  check::all_finite(tangents, "tangents", "");
  MetersDescription meters{d.kind, nullptr, {}, read_vectors(normals), read_vectors(tangents), width, height,
                           d.footprint_m};
  std::vector<Vec3d> positions;
  for (size_t i = 0; i < d.count; ++i) {
    const double* p = d.positions_m + 3 * i;
    positions.emplace_back(p[0], p[1], p[2]);
    meters.bounds.grow(positions.back());
    const Vec3d n(meters.normals[i]);
    if (!(length(n) > 0))
      fail_argument("normals: element " + std::to_string(i) + " has length 0; it must point somewhere");
    if (d.kind == UPS_METER_SEMICYLINDRICAL && !(std::hypot(n.x, n.y) > 1e-6 * length(n)))
      fail_argument("normals: element " + std::to_string(i) +
                    " is vertical; a semicylindrical meter faces the horizontal part of its normal");
    if (meters.tangents.empty()) continue;
    const Vec3d t(meters.tangents[i]);
    if (!(length(cross(n, t)) > 1e-6 * length(n) * length(t)))
      fail_argument("tangents: element " + std::to_string(i) +
                    " is parallel to its normal, or 0; it must point along a side");
  }
  meters.positions = std::make_shared<const std::vector<Vec3d>>(std::move(positions));
  return meters;
}

std::vector<ups_instance_id> Description::read_instances(const ups_instance_id* ids, uint32_t count,
                                                         uint64_t& triangles) const {
  check_count(count, 1, max_id_number, "instance_count");
  check::pointer(ids, "instances");
  std::set<uint32_t> seen;
  for (uint32_t i = 0; i < count; ++i) {
    const std::string field = check::element("instances", i);
    check::require(ids[i].v != 0, field + " is 0; it must be an instance of the scene");
    const InstanceDescription& instance = instances_.get(ids[i].v, (field + ": instance").c_str());
    const Mesh& mesh = meshes_.at(instance.mesh);
    const uint32_t number = number_of(ids[i].v);
    check::require(seen.insert(number).second, field + ": instance " + std::to_string(number) + " is listed twice");
    check::require(!mesh.revolution, field + ": instance " + std::to_string(number) +
                                         " is a curved part of a fixture, which has no triangles; meters on surfaces "
                                         "want an instance of a mesh");
    triangles += mesh.triangle_count();
  }
  return {ids, ids + count};
}

Description::Sensor Description::read(const ups_surface_meters_desc& d) const {
  uint64_t triangles = 0;
  SurfaceMetersDescription meters{read_instances(d.instances, d.instance_count, triangles), d.back == 1, 0, 0};
  check::require(triangles <= max_meters, "instances have " + std::to_string(triangles) +
                                              " triangles together; a set measures at most " +
                                              std::to_string(max_meters));
  check::flag(d.back, "back");
  check_reserved(d.reserved);
  return meters;
}

Description::Sensor Description::read(const ups_lightmap_desc& d) const {
  uint64_t triangles = 0;
  SurfaceMetersDescription map{read_instances(d.instances, d.instance_count, triangles), d.back == 1, d.width,
                               d.height};
  check_count(d.width, 1, 16384, "width");
  check_count(d.height, 1, 16384, "height");
  check::require(uint64_t(d.width) * d.height <= max_meters,
                 "width * height is " + std::to_string(uint64_t(d.width) * d.height) + "; it must be at most " +
                     std::to_string(max_meters));
  for (const ups_instance_id instance : map.instances)
    check::require(!meshes_.at(instances_.at(number_of(instance.v)).mesh).uvs.empty(),
                   "instances: the mesh of instance " + std::to_string(number_of(instance.v)) +
                       " has no uvs; a lightmap needs them to place its texels (ups_mesh_desc.uvs)");
  check::flag(d.back, "back");
  check_reserved(d.reserved);
  return map;
}

namespace {

// The angles as given, or equal steps; checked by element.
std::vector<double> angles_of(const float* given, uint32_t count, double step, double limit, bool limit_allowed,
                              const std::string& field) {
  std::vector<double> angles;
  for (uint32_t i = 0; i < count; ++i) {
    const double a = given ? double(given[i]) : std::min(i * step, limit);  // which rounding may pass
    check::require(a >= 0 && (a < limit || (limit_allowed && a == limit)),
                   check::element(field, i) + " is " + check::text(a) + "; it must be in [0, " + check::text(limit) +
                       (limit_allowed ? "]" : ")"));
    check::require(i == 0 || a > angles.back(),
                   check::element(field, i) + " is " + check::text(a) + "; it must be greater than the one before");
    angles.push_back(a);
  }
  return angles;
}

}  // namespace

Description::Sensor Description::read(const ups_goniometer_desc& d) const {
  constexpr uint64_t most = photometry::Distribution::max_values;
  check::enumeration(d.symmetry, UPS_SYMMETRY_QUADRANTS, "symmetry", "UPS_SYMMETRY_*");
  check::enumeration(d.opening_shape, UPS_OPENING_SPHERE, "opening_shape", "UPS_OPENING_*");
  check_count(d.c_count, 1, most, "c_count");
  check_count(d.gamma_count, 2, most, "gamma_count");
  check::require(uint64_t(d.c_count) * d.gamma_count <= most,
                 "c_count * gamma_count is " + std::to_string(uint64_t(d.c_count) * d.gamma_count) +
                     "; it must be at most " + std::to_string(most));
  check::transform(d.to_world, "to_world");
  GoniometerDescription g{to_affine(d.to_world), d.symmetry, {}, {}, {}, {}, {}};
  g.c_deg = angles_of(d.c_deg, d.c_count, 360.0 / d.c_count, 360, false, "c_deg");
  g.gamma_deg = angles_of(d.gamma_deg, d.gamma_count, 180.0 / (d.gamma_count - 1), 180, true, "gamma_deg");
  check::require(g.c_deg[0] == 0, "c_deg[0] is " + check::text(g.c_deg[0]) + "; the first plane must be 0");
  if (!d.gamma_deg) g.gamma_deg.back() = 180;
  if (d.c_deg) g.given_c_deg.assign(d.c_deg, d.c_deg + d.c_count);
  if (d.gamma_deg) g.given_gamma_deg.assign(d.gamma_deg, d.gamma_deg + d.gamma_count);
  g.opening.shape = photometry::OpeningShape(d.opening_shape);
  for (int k = 0; k < 3; ++k) {
    check::range(double(d.opening_m[k]), 0, 1e6, check::element("opening_m", size_t(k)));
    g.opening.size_m[k] = d.opening_m[k];
  }
  Goniometer(Frame(Vec3(0, 0, 1)), g.c_deg, g.gamma_deg, Goniometer::Symmetry(d.symmetry));  // throws what is wrong
  return g;
}

Description::Sensor Description::read(const ups_observer_desc& d) const {
  check::enumeration(d.metric, UPS_GLARE_METRIC_UGR, "metric", "UPS_GLARE_METRIC_*");
  check::enumeration(d.position_index, UPS_POSITION_INDEX_GUTH, "position_index", "UPS_POSITION_INDEX_*");
  check::at_least(double(d.ceiling_area_m2), 0, "ceiling_area_m2");
  check::transform(d.to_world, "to_world");
  return ObserverDescription{to_affine(d.to_world), d.position_index, d.ceiling_area_m2};
}

// ---- add, set ----

ups_sensor_id Description::add_camera(const ups_camera_desc& d) { return {add(sensors_, read(d))}; }
ups_sensor_id Description::add_meters(const ups_meter_desc& d) { return {add(sensors_, read(d))}; }
ups_sensor_id Description::add_surface_meters(const ups_surface_meters_desc& d) { return {add(sensors_, read(d))}; }
ups_sensor_id Description::add_lightmap(const ups_lightmap_desc& d) { return {add(sensors_, read(d))}; }
ups_sensor_id Description::add_goniometer(const ups_goniometer_desc& d) { return {add(sensors_, read(d))}; }
ups_sensor_id Description::add_observer(const ups_observer_desc& d) { return {add(sensors_, read(d))}; }

namespace {

std::string kind_of(const Description::Sensor& sensor) {
  if (const auto* surface = std::get_if<SurfaceMetersDescription>(&sensor))
    return surface->width > 0 ? "a lightmap" : "a set of meters on surfaces";
  constexpr const char* names[] = {"a camera", "a set of meters", "", "a goniometer", "an observer"};
  return names[sensor.index()];
}

}  // namespace

template <class Kind>
const Kind& Description::sensor_of(ups_sensor_id id) const {
  const Sensor& sensor = sensors_.get(id.v, "sensor");
  const auto* kind = std::get_if<Kind>(&sensor);
  if (!kind)
    fail_argument("sensor id " + std::to_string(number_of(id.v)) + " is " + kind_of(sensor) + ", not " +
                  kind_of(Sensor(Kind{})));
  return *kind;
}

const SurfaceMetersDescription& Description::surface_of(ups_sensor_id id, bool is_lightmap) const {
  const Sensor& sensor = sensors_.get(id.v, "sensor");
  const auto* surface = std::get_if<SurfaceMetersDescription>(&sensor);
  if (!surface || (surface->width > 0) != is_lightmap)
    fail_argument("sensor id " + std::to_string(number_of(id.v)) + " is " + kind_of(sensor) +
                  (is_lightmap ? ", not a lightmap" : ", not a set of meters on surfaces"));
  return *surface;
}

void Description::set_camera(ups_sensor_id id, const ups_camera_desc& d) {
  sensor_of<CameraDescription>(id);
  set(sensors_, id.v, read(d), "sensor");
}
void Description::set_meters(ups_sensor_id id, const ups_meter_desc& d) {
  sensor_of<MetersDescription>(id);
  set(sensors_, id.v, read(d), "sensor");
}
void Description::set_surface_meters(ups_sensor_id id, const ups_surface_meters_desc& d) {
  surface_of(id, false);
  set(sensors_, id.v, read(d), "sensor");
}
void Description::set_lightmap(ups_sensor_id id, const ups_lightmap_desc& d) {
  surface_of(id, true);
  set(sensors_, id.v, read(d), "sensor");
}
void Description::set_goniometer(ups_sensor_id id, const ups_goniometer_desc& d) {
  sensor_of<GoniometerDescription>(id);
  set(sensors_, id.v, read(d), "sensor");
}
void Description::set_observer(ups_sensor_id id, const ups_observer_desc& d) {
  sensor_of<ObserverDescription>(id);
  set(sensors_, id.v, read(d), "sensor");
}

// ---- as they stand ----

ups_camera_desc Description::camera(ups_sensor_id id) const {
  const auto& c = sensor_of<CameraDescription>(id);
  ups_camera_desc d{};
  d.projection = c.projection, d.width = c.width, d.height = c.height;
  copy_transform(c.to_world, d.to_world);
  d.vertical_fov_rad = c.vertical_fov_rad, d.illuminance = c.illuminance, d.layers = c.layers;
  return d;
}

ups_meter_desc Description::meters(ups_sensor_id id) const {
  const auto& m = sensor_of<MetersDescription>(id);
  static_assert(sizeof(Vec3d) == 3 * sizeof(double));
  ups_meter_desc d{};
  d.kind = m.kind, d.count = uint32_t(m.positions->size());
  d.positions_m = &m.positions->data()->x;
  d.normals = &m.normals.data()->x;
  d.tangents = m.tangents.empty() ? nullptr : &m.tangents.data()->x;
  d.cell_size_m[0] = m.cell_width, d.cell_size_m[1] = m.cell_height, d.footprint_m = m.footprint;
  return d;
}

ups_surface_meters_desc Description::surface_meters(ups_sensor_id id) const {
  const SurfaceMetersDescription& m = surface_of(id, false);
  ups_surface_meters_desc d{};
  d.instance_count = uint32_t(m.instances.size()), d.instances = m.instances.data(), d.back = m.back;
  return d;
}

ups_lightmap_desc Description::lightmap(ups_sensor_id id) const {
  const SurfaceMetersDescription& m = surface_of(id, true);
  ups_lightmap_desc d{};
  d.instance_count = uint32_t(m.instances.size()), d.instances = m.instances.data(), d.back = m.back;
  d.width = m.width, d.height = m.height;
  return d;
}

ups_goniometer_desc Description::goniometer(ups_sensor_id id) const {
  const auto& g = sensor_of<GoniometerDescription>(id);
  ups_goniometer_desc d{};
  d.symmetry = g.symmetry;
  d.c_count = uint32_t(g.c_deg.size()), d.gamma_count = uint32_t(g.gamma_deg.size());
  d.c_deg = g.given_c_deg.empty() ? nullptr : g.given_c_deg.data();
  d.gamma_deg = g.given_gamma_deg.empty() ? nullptr : g.given_gamma_deg.data();
  copy_transform(g.to_world, d.to_world);
  d.opening_shape = ups_opening_shape(g.opening.shape);
  std::copy(g.opening.size_m, g.opening.size_m + 3, d.opening_m);
  return d;
}

ups_observer_desc Description::observer(ups_sensor_id id) const {
  const auto& o = sensor_of<ObserverDescription>(id);
  ups_observer_desc d{};
  d.metric = UPS_GLARE_METRIC_UGR, d.position_index = o.position_index;
  d.ceiling_area_m2 = o.ceiling_area;
  copy_transform(o.to_world, d.to_world);
  return d;
}

}  // namespace ups
