// Half planes of one table by their azimuth: mirror images that make the full circle of what a file states in part, and
// the part that a writer needs to state. Used by the readers and writers of photometric files.
#pragma once
#include <cmath>

#include "photometry/photometry.h"

namespace photometry {

struct Plane {
  double c_deg;
  std::vector<double> intensity_cd;
};

// Whether two angles of a file, in degrees, mean the same.
inline bool is_near(double a, double b) { return std::abs(a - b) < 1e-3; }

// The planes that a file states, in any order within [0, 360), become those of the full circle, ascending from 0:
// mirror images where there is a symmetry, an interpolated plane at 0 where there is none.
void complete_circle(std::vector<Plane>& planes, Symmetry symmetry);

// What planes that start at 0 leave open before 360, degrees, where that is at least twice any step between them: more
// than a plane that was left out, so that a symmetry was meant. Else 0.
double open_end_deg(const std::vector<double>& c_deg);

// 0 to 360 states the first plane twice: the last one is taken out, their mean stays. Warns where they differ by more
// than 1 % of the peak.
void join_ends(std::vector<Plane>& planes, size_t line, std::vector<std::string>& warnings);

// At the nadir and at the zenith all planes of a type C table are one direction: warns where they differ there by more
// than 1 % of the peak.
void check_poles(const Distribution& distribution, size_t line, std::vector<std::string>& warnings);

// Of a type C table, or of a table of type A or B, planes of ascending angle and their rows.
Distribution distribution_of(PhotometricType type, std::vector<Plane> planes, std::vector<double> row_deg);

// The symmetry that the values of a type C table have, to so much of the peak. The planes on which the mirror images meet
// must exist (0 and 180; 90 and 270; all four), or a part of the circle could not state the table.
Symmetry symmetry_of(const Distribution& distribution, double tolerance = 1e-12);

// How a table of type A or B repeats: c0_c180 for H and -H, c90_c270 for V and -V, each with a value at 0.
Symmetry mirror_symmetry_of(const Distribution& distribution);

}  // namespace photometry
