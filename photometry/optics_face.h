// What the profiles of optics.cpp and optics_collimator.cpp share: lens faces, straight pieces, checks.
#pragma once
#include "photometry/optics.h"

namespace optics {

// Sag of a face; its normal is (slope, one) up to length, `slope` along r, `one` away from the lens.
struct FacePoint {
  double sag, slope, one;
};
FacePoint face_point(const Face& face, double r);
// Finite, and defined out to the rim; `name` is what the fields begin with ("entry").
void check_face(const Face& face, double radius, const char* name);
// A face with its vertex on the axis at vertex_z, of the lower side of a lens or the upper one, walked from the axis or
// towards it.
Section face_section(const Face& face, double radius, double vertex_z, bool below, bool inwards);
Section line(const Point& a, const Point& b);
void positive(double value, const char* field);

}  // namespace optics
