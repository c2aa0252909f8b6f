// The light in an empty box of a room, evenly spread over ceiling, walls and floor: the transfer method of CIE 52
// (1982), which the tables of utilisation factors and of UGR (CIE 190:2010) are made by. The standard library only.
#pragma once
#include <array>
#include <vector>

#include "photometry/distribution.h"

namespace photometry {

// From the reference plane up to the plane of the luminaires; lengths in units of the height between them.
struct RoomShape {
  double x, y;
  double floor_area() const { return x * y; }
  double wall_area() const { return 2 * (x + y); }
  double index() const { return x * y / (x + y); }  // of the room
};

struct Reflectances {
  double ceiling, walls, floor;
};

using RoomFlux = std::array<double, 3>;  // of floor, walls, ceiling

// Exchange of light between the three surfaces, each diffuse and lit evenly, by their exact form factors (two equal
// parallel rectangles: Howell's catalogue C-11). The flux that each receives in all, of the flux that comes to them
// straight from the luminaires.
RoomFlux exchange(const RoomShape& room, const Reflectances& rho, const RoomFlux& direct);

// The rays of a distribution, to be asked where they go in many rooms: a quadrature by the midpoint rule, half a degree
// of gamma and two of C, that makes up the distribution's flux by the band rule.
class RoomRays {
 public:
  // Throws std::invalid_argument where there is no flux.
  RoomRays(const Distribution& distribution, double flux_lm);
  // The shares of the flux that luminaires in the ceiling plane send to each surface straight: of a regular array with
  // columns * rows of them, the outer ones half a spacing from the walls, or, with 0, spread evenly. C0 is along x.
  RoomFlux direct_shares(const RoomShape& room, int columns, int rows) const;

 private:
  struct Ray {
    double dx, dy, share;  // where it meets the reference plane, from its luminaire
  };
  std::vector<Ray> down_;
  double up_ = 0;
};

}  // namespace photometry
