// From values to colours: a map's scale, its tables of colours, those of verdicts. Called by map.cpp and map_plot.cpp.
#pragma once
#include "report/isolines.h"

namespace ups::report {

Ink colour_at(MapColours colours, double share);  // 0: low, 1: high, others as the nearer end

struct MapRange {
  MapScale scale = MapScale::linear;
  double low = 0, high = 1;
  double least = -1, most = -1;  // of the values; -1: none is known
  std::vector<double> levels;    // of isolines, and of the scale's numbers
  double share(double value) const;
};
// As the style says, else from the values: rounded to whole steps.
MapRange range_of(const MapData& data, const MapStyle& style);

// Told apart by colour-blind people and, met from not met, in grey.
Ink ink_of(Verdict verdict);

}  // namespace ups::report
