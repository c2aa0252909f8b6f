// Expands the planes of a type C file to the full circle, by the range of its horizontal angles. Called by ies.cpp.
#pragma once
#include <cmath>

#include "photometry/ies_edition.h"

namespace photometry {

struct IesPlane {
  double c_deg;
  std::vector<double> intensity_cd;
};

// Whether two angles of a file, in degrees, mean the same.
inline bool is_near(double a, double b) { return std::abs(a - b) < 1e-3; }

// planes: ascending, as in the file; becomes ascending in [0, 360) from 0 (one plane: as it is, at 0). Throws
// ParseError with the line of the table for ranges that are not of type C.
Symmetry arrange_ies_planes(std::vector<IesPlane>& planes, IesEdition edition, size_t line,
                            std::vector<std::string>& warnings);

}  // namespace photometry
