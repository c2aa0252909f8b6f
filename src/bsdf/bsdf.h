// How a surface point scatters light: the one interface of all material models, in the local shading frame (z = n_s,
// the surface's front). Built per surface point from a Material (bsdf/material.h); used by both walks and by
// connections.
//
// Conventions: both directions point away from the surface. `wo` is where the walk came from, `wi` where it goes.
// eval() is f * |cos(wi)|. Densities are per solid angle; every continuous density includes the probability of not
// choosing a delta lobe. Opaque models behave alike on both sides.
#pragma once
#include "base/rgb.h"
#include "base/vec.h"

namespace ups {

// What the walk carries. Radiance (eye walk) is scaled by (n_wo/n_wi)^2 on refraction, importance (light walk) is not
// (Veach 1997, 5.2).
enum class TransportMode { radiance, importance };

// Everything about one pair of directions that a technique and its weight need.
struct Scattering {
  Rgb value;              // f * |cos(wi)|
  float pdf = 0;          // of wi given wo
  float pdf_reverse = 0;  // of wo given wi
};

struct BsdfSample {
  Vec3 wi;                // local, unit
  Rgb weight;             // f * |cos| / pdf, or lobe's reflectance / probability for a delta lobe
  float pdf = 0;          // of wi given wo: per solid angle, or the discrete probability of a delta lobe
  float pdf_reverse = 0;  // the same scattering event backwards: of wo given wi
  bool delta = false;
  bool transmitted = false;  // wi on the other side of the surface than wo
  // Delta lobes: (n_i^2 cos_i) / (n_o^2 cos_o) with i = side of wo, o = side of wi, shading cosines; 1 for reflection
  // and for thin panes (what remains of the MIS factor without its probabilities).
  float delta_jacobian = 1;
};

}  // namespace ups
