// Where the meters of a node's `extras.ups.meters` lie, as its words say. Called by meters.cpp.
#pragma once
#include <vector>

#include "gltf/import.h"

namespace ups::gltf {

inline constexpr int64_t max_meters = 16777216;  // ups_meter_desc

struct MeterData {
  std::vector<double> positions;
  std::vector<float> normals;
  ups_gltf_layout layout = UPS_GLTF_LAYOUT_POINTS;
  bool area = false;  // the mean over each cell is asked for
  double cell_width = 0, cell_height = 0;
  Vector cell_side{};
  uint32_t columns = 0, rows = 0;  // 0: not all cells of a grid

  void add(const Vector& position, const Vector& normal) {
    const double size = length(normal);
    positions.insert(positions.end(), position.begin(), position.end());
    for (double n : normal) normals.push_back(float(n / size));
  }
};

// meter_layouts.cpp; frame: of the node.
MeterData read_en12464(const JsonReader& meters, const Affine& frame);
MeterData read_line(const JsonReader& meters, const Affine& frame);

}  // namespace ups::gltf
