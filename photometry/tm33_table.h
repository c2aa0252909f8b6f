// Intensities of single directions, in any order, made a table; and tables of several emitters added up. Used by
// tm33.cpp and tm33_elements.cpp.
#pragma once
#include "photometry/photometry.h"

namespace photometry {

struct DirectedValue {
  double h_deg, v_deg, value;
  size_t line;
};

// Planes of equal h with the same v each. A direction v = 0 or 180 that a plane lacks is taken from another: it is the
// same. Throws ParseError for directions that are missing or stated twice with different values. `line`: of the block.
Distribution table_of(std::vector<DirectedValue> values, PhotometricType type, size_t line, Symmetry& symmetry,
                      std::vector<std::string>& warnings);

// The sum of distributions of type C, on the planes and rows of all. Throws std::invalid_argument where it is too
// large.
Distribution sum_of(const std::vector<Distribution>& parts);

}  // namespace photometry
