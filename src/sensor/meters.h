// A set of illuminance meters: points, or cells whose mean is measured. Planar meters see their normal's hemisphere.
#pragma once
#include <cstdint>
#include <vector>

#include "base/frame.h"

namespace ups {

struct Meter {
  Vec3 p;       // relative to the scene's origin; a cell's centre
  Frame frame;  // n: the normal; s, t: a cell's sides
  float error = 0;  // of p; a meter that lies on a surface stands on the side of its normal
};

struct MeterSet {
  std::vector<Meter> meters;
  float cell_width = 0, cell_height = 0;  // along frame.s, frame.t; 0: points
  bool is_cell() const { return cell_width > 0 && cell_height > 0; }
  float cell_area() const { return cell_width * cell_height; }
};

}  // namespace ups
