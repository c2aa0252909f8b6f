// What the optics_*.cpp and optics.cpp share: lens faces, straight pieces, checks, quadrics.
#pragma once
#include <optional>

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
// Of the piece between two parameters, of a shape of this size; none where the piece is too long for a quadric.
std::optional<Band> fit_band(const Section& section, double low, double high, double size);

}  // namespace optics
