// A set of illuminance meters: where they are, points or cells whose mean is measured, and of which kind.
#pragma once
#include <cstdint>
#include <vector>

#include "sensor/response.h"

namespace ups {

struct Meter {
  Vec3 p;       // relative to the scene's origin; a cell's centre
  Frame frame;  // n: the normal; s, t: a cell's sides
  // Of p; a planar meter that lies on a surface stands on the side of its normal. Others are there already: 0.
  float error = 0;
};

struct MeterSet {
  ups_meter_kind kind = UPS_METER_PLANAR;
  // Of a vector set all of them six times, for one side after the other: see count(), number().
  std::vector<Meter> meters;
  float cell_width = 0, cell_height = 0;  // along frame.s, frame.t; 0: points
  bool is_cell() const { return cell_width > 0 && cell_height > 0; }
  float cell_area() const { return cell_width * cell_height; }
  // As the caller counts them.
  size_t count() const { return kind == UPS_METER_VECTOR ? meters.size() / vector_sides : meters.size(); }
  uint32_t number(uint32_t m) const { return kind == UPS_METER_VECTOR ? uint32_t(m % count()) : m; }
  bool across() const { return kind != UPS_METER_PLANAR && !is_cell(); }
  MeterResponse response(uint32_t m) const {
    if (kind == UPS_METER_PLANAR) return {};
    return {kind, across(), kind == UPS_METER_VECTOR ? uint8_t(m / count()) : uint8_t(0)};
  }
};

}  // namespace ups
