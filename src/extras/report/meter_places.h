// Where the meters of a scene are: what it lists, and what a commit has put on its surfaces.
#pragma once
#include <vector>

#include "report/lit_scene.h"

namespace ups::report {

struct MeterPlaces {
  std::vector<double> positions;          // 3 a meter, m
  std::vector<float> normals;             // 3 a meter, of length 1
  std::vector<ups_meter_place> surfaces;  // of triangles and texels; else none
  std::vector<size_t> listed;             // all but a lightmap's empty texels

  // A triangle without area has none.
  bool has_place(size_t meter) const { return surfaces.empty() || surfaces[meter].valid; }
};

// Of a set of meters.
MeterPlaces meter_places(const LitScene& scene, const SensorEntry& meters);

}  // namespace ups::report
