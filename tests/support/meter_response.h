// What a meter of each kind makes of light from a direction: the definitions that tests hold the engine to.
#pragma once
#include <algorithm>
#include <cmath>

#include "shapes.h"
#include "ups/ups.h"

namespace ups::test {

inline constexpr ups_meter_kind all_kinds[] = {UPS_METER_PLANAR,        UPS_METER_CYLINDRICAL, UPS_METER_SEMICYLINDRICAL,
                                               UPS_METER_HEMISPHERICAL, UPS_METER_SPHERICAL,   UPS_METER_VECTOR};

// W of a unit direction towards the light; a vector's own.
inline double response(ups_meter_kind kind, const P3& normal, const P3& w) {
  const P3 n = normalize(normal);
  const double sine = std::hypot(w.x, w.y), facing = std::hypot(n.x, n.y), c = dot(n, w);
  switch (kind) {
    case UPS_METER_CYLINDRICAL: return sine / pi_d;
    case UPS_METER_SEMICYLINDRICAL: return (sine + (w.x * n.x + w.y * n.y) / facing) / pi_d;
    case UPS_METER_HEMISPHERICAL: return c > 0 ? (1 + c) / 4 : 0;
    case UPS_METER_SPHERICAL: return 0.25;
    default: return std::max(0.0, c);
  }
}
inline double component(const P3& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }

}  // namespace ups::test
