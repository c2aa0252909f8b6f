// What a map shows, from a scene and its result or from plain numbers, such as those of a file. Called by the C API,
// the page, `ups render` and `ups map`.
#pragma once
#include <optional>

#include "report/lit_scene.h"
#include "report/map.h"

namespace ups::report {

struct MeterPoint {
  double position_m[3], normal[3];
  double illuminance_lx, error_bound_lx;
  double area_m2 = 0;  // its weight in the mean; 0 of all: they are alike
};

// Of points in one plane, seen against its normal; nothing where they lie in none, or on one line, or are more than
// 20,000 on no lattice. columns: of a grid, else 0. scene: committed, whose plan and observers are drawn; may be null.
// A wall's map is upright, a grid's has its row 0 below, or above where its rows run downwards or south, as one reads.
// row_0_below: it has it below, whichever way they run, as its image file has.
std::optional<MapData> meter_map(const std::string& name, const std::vector<MeterPoint>& points, uint32_t columns,
                                 const LitScene* scene, bool row_0_below = false);
// Of a set of meters of a render, but of a mesh's surface. A scene file's grid has its row 0 below.
std::optional<MapData> meter_map(const SensorEntry& meters, const LitScene& scene, const ups_result* result);
// 0: they are no grid whose columns run fastest.
uint32_t columns_of(const double* positions_m, size_t count);

// Of a fisheye's pixels, one value each, those outside of its image circle become unknown: no light is measured there.
std::vector<float> within_image(const SensorInfo& camera, std::vector<float> values);
// Of a camera's image. values and their 95 % bounds (< 0: not known; none at all: of none): columns * rows, row 0 at
// the top.
MapData image_map(const std::string& name, const std::string& quantity, const std::string& unit,
                  const std::vector<float>& values, const std::vector<float>& bounds, uint32_t columns, uint32_t rows);
// The same of a grid or a lightmap, whose illuminance has a uniformity. weights: in the mean, areas of a lightmap's
// texels; none: all alike.
MapData image_map(const std::string& name, const std::string& quantity, const std::string& unit,
                  const std::vector<float>& values, const std::vector<float>& bounds, uint32_t columns, uint32_t rows,
                  const std::vector<float>& weights);
const char* quantity_of(ups_meter_kind kind);  // that its meters read
MapStyle of_luminance(MapStyle style);  // with the threshold of luminances
std::vector<float> luminance_of(const std::vector<float>& rgb);

// Below a map's title; bound: of the mean, -1: not known. U0 of illuminances alone, but not of a camera's.
std::string summary_text(double mean, double mean_bound, double min, double max, double worst_relative_bound,
                         const std::string& unit, bool of_camera = false);
// The same of points of which nothing but their values is known.
std::string summary_of(const std::vector<MeterPoint>& points);

// ---- parts, each in a file of its own

// Where a map's plane lies: axes of length 1, normal towards who looks.
struct MapPlane {
  double origin[3], right[3], up[3], normal[3];
  Place flat(const double* p) const {
    Place place{0, 0};
    for (int k = 0; k < 3; ++k) place.x += (p[k] - origin[k]) * right[k], place.y += (p[k] - origin[k]) * up[k];
    return place;
  }
  Place direction(const double* v) const {
    Place d{0, 0};
    for (int k = 0; k < 3; ++k) d.x += v[k] * right[k], d.y += v[k] * up[k];
    return d;
  }
};

// Fills room, luminaires and observers: what the plane cuts, what lies beneath it, what shines, who looks. Lines far
// from the values are left out.
void add_room(MapData& data, const MapPlane& plane, const LitScene& scene);

}  // namespace ups::report
