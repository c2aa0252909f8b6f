// Where the meters of a scene file are: what it lists, and what a commit has put on its surfaces.
#pragma once
#include <vector>

#include "tool/handles.h"

namespace ups::tool {

struct MeterPlaces {
  std::vector<double> positions;          // 3 a meter, m
  std::vector<float> normals;             // 3 a meter
  std::vector<ups_meter_place> surfaces;  // of triangles and texels; else none
  std::vector<size_t> listed;             // all but a lightmap's empty texels
};

// index: of the sensor, of meters; the scene is committed.
MeterPlaces meter_places(const LoadedScene& scene, uint32_t index);

}  // namespace ups::tool
