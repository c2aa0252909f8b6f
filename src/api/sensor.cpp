// ups_sensor.h: cameras, meters and goniometers.
#include "api/desc.h"
#include "api/handles.h"
#include "sensor/en12464.h"

using namespace ups;
using namespace ups::api;

namespace {

ups_meter_place place_of(const MeterSet& set, uint32_t number, const Vec3d& origin) {
  ups_meter_place place{};
  const bool triangles = set.on_surface() && set.surface_triangle.empty();
  const uint32_t m = set.index_of(number);
  place.triangle = triangles ? number : UINT32_MAX;
  if (m == UINT32_MAX) return place;
  const Meter& meter = set.meters[m];
  const Vec3d p = set.positions ? (*set.positions)[m] : Vec3d(meter.p) + origin;
  for (int k = 0; k < 3; ++k) {
    place.position_m[k] = p[k];
    place.normal[k] = meter.frame.n[k];
  }
  place.area_m2 = float(set.area(m));
  place.valid = 1;
  if (set.on_surface() && !triangles) place.triangle = set.surface_triangle[m];
  return place;
}

PlanOutline outline(const double* corners, size_t count) {
  PlanOutline out;
  for (size_t i = 0; i < count; ++i) out.push_back({corners[2 * i], corners[2 * i + 1]});
  return out;
}

En12464Area area_of(const ups_en12464_desc& d) {
  if (d.corner_count > 0) require(d.corners_m, "corners_m");
  if (d.reserved != 0) fail_argument("reserved is " + std::to_string(d.reserved) + "; it must be 0");
  if (d.hole_count > 0) {
    require(d.hole_corners_m, "hole_corners_m");
    require(d.hole_corner_counts, "hole_corner_counts");
  }
  // Before any corner is read.
  uint64_t corners = d.corner_count;
  for (uint32_t h = 0; h < d.hole_count && corners <= most_en12464_corners; ++h)
    corners += std::max(d.hole_corner_counts[h], 1u);
  check_en12464_corners(corners);
  En12464Area area{outline(d.corners_m, d.corner_count), {}, d.border_m};
  size_t begin = 0;
  for (uint32_t h = 0; h < d.hole_count; ++h) {
    area.holes.push_back(outline(d.hole_corners_m + 2 * begin, d.hole_corner_counts[h]));
    begin += d.hole_corner_counts[h];
  }
  return area;
}

}  // namespace

void ups_camera_desc_init(ups_camera_desc* desc, uint32_t struct_size) {
  ups_camera_desc d{};
  d.projection = UPS_PERSPECTIVE;
  d.width = d.height = 512;
  set_identity(d.to_world);
  d.vertical_fov_rad = pi / 3;
  write_defaults(desc, struct_size, d);
}

void ups_meter_desc_init(ups_meter_desc* desc, uint32_t struct_size) {
  write_defaults(desc, struct_size, ups_meter_desc{});
}

void ups_surface_meters_desc_init(ups_surface_meters_desc* desc, uint32_t struct_size) {
  write_defaults(desc, struct_size, ups_surface_meters_desc{});
}

void ups_lightmap_desc_init(ups_lightmap_desc* desc, uint32_t struct_size) {
  ups_lightmap_desc d{};
  d.width = d.height = 256;
  write_defaults(desc, struct_size, d);
}

void ups_en12464_desc_init(ups_en12464_desc* desc, uint32_t struct_size) {
  ups_en12464_desc d{};
  d.border_m = 0.5;
  write_defaults(desc, struct_size, d);
}

void ups_goniometer_desc_init(ups_goniometer_desc* desc, uint32_t struct_size) {
  ups_goniometer_desc d{};
  d.c_count = 24;
  d.gamma_count = 73;
  set_identity(d.to_world);
  write_defaults(desc, struct_size, d);
}

ups_status ups_scene_add_goniometer(ups_scene* scene, const ups_goniometer_desc* desc, ups_sensor_id* out) {
  return guard(__func__, [&] {
    require(scene, "scene");
    require(out, "out");
    *out = scene->description.add_goniometer(read_desc(desc, &ups_goniometer_desc_init));
  });
}

ups_status ups_scene_add_camera(ups_scene* scene, const ups_camera_desc* desc, ups_sensor_id* out) {
  return guard(__func__, [&] {
    require(scene, "scene");
    require(out, "out");
    *out = scene->description.add_camera(read_desc(desc, &ups_camera_desc_init));
  });
}

ups_status ups_scene_add_meters(ups_scene* scene, const ups_meter_desc* desc, ups_sensor_id* out) {
  return guard(__func__, [&] {
    require(scene, "scene");
    require(out, "out");
    *out = scene->description.add_meters(read_desc(desc, &ups_meter_desc_init));
  });
}

ups_status ups_scene_add_surface_meters(ups_scene* scene, const ups_surface_meters_desc* desc, ups_sensor_id* out) {
  return guard(__func__, [&] {
    require(scene, "scene");
    require(out, "out");
    *out = scene->description.add_surface_meters(read_desc(desc, &ups_surface_meters_desc_init));
  });
}

ups_status ups_scene_add_lightmap(ups_scene* scene, const ups_lightmap_desc* desc, ups_sensor_id* out) {
  return guard(__func__, [&] {
    require(scene, "scene");
    require(out, "out");
    *out = scene->description.add_lightmap(read_desc(desc, &ups_lightmap_desc_init));
  });
}

ups_status ups_scene_read_meter_places(const ups_scene* scene, ups_sensor_id meters, ups_meter_place* places,
                                       size_t capacity, size_t* needed) {
  return guard(__func__, [&] {
    const auto build = committed(scene);
    const Snapshot& s = *build->snapshot;
    const uint32_t number = own_number_of(meters.v, s.tag->bits(), "sensor");
    const auto at = std::find(s.meter_set_ids.begin(), s.meter_set_ids.end(), number);
    if (at == s.meter_set_ids.end())
      fail_argument("meters: sensor id " + std::to_string(number) +
                    " is not a set of meters of the scene as it was committed");
    const MeterSet& set = s.meter_sets[size_t(at - s.meter_set_ids.begin())];
    copy_array(set.count(), places, capacity, needed, "places",
               [&](size_t i) { return place_of(set, uint32_t(i), s.origin); });
  });
}

ups_status ups_en12464_grid(const ups_en12464_desc* desc, ups_en12464_info* info, ups_en12464_point* points,
                            size_t capacity, size_t* needed) {
  return guard(__func__, [&] {
    const En12464Grid grid = en12464_grid(area_of(read_desc(desc, &ups_en12464_desc_init)));
    if (info) checked_size(info, "info");  // before anything is written
    size_t count = 0;  // whoever asks for `info` alone has it there
    copy_array(grid.points.size(), points, capacity, needed || !info ? needed : &count, "points", [&](size_t i) {
      const En12464Grid::Point& p = grid.points[i];
      return ups_en12464_point{p.at.x, p.at.y, p.column, p.row};
    });
    if (info)
      write_info(info,
                 {uint32_t(sizeof *info), grid.columns, grid.rows, uint32_t(grid.points.size()),
                  {grid.origin.x, grid.origin.y}, {grid.cell.x, grid.cell.y}, grid.largest_spacing},
                 "info");
  });
}
