// Lines along which a map has one value, and which values people like to read there. Called by map.cpp.
#pragma once
#include "report/map_field.h"

namespace ups::report {

// Linear: equal steps of 1, 2 or 5 times a power of ten, up to ten of them. Logarithmic: the steps of EN 12464-1,
// 1, 1.5, 2, 3, 5, 7.5 times powers of ten, or fewer of them.
std::vector<double> isoline_levels(double low, double high, MapScale scale);

struct Isoline {
  double level;
  std::vector<Place> points;  // the first again at the end of a closed one
};
// None without a lattice.
std::vector<Isoline> isolines_of(const MapField& field, const std::vector<double>& levels);

// An image with fewer, calmer pixels, in the same coordinates: medians of blocks, smoothed. Isolines of the image itself
// would follow its noise. One of few pixels, such as that of a grid of meters, as it is.
MapData calmed(const MapData& image);

}  // namespace ups::report
