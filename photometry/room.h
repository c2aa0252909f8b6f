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

// The rays of a distribution, to be asked where they go in many rooms: 200 x 200 of equal flux, drawn from an even
// lattice by the distribution's own sampling, so that none of its light is missed, however narrow it is.
class RoomRays {
 public:
  // Throws std::invalid_argument where there is no flux.
  explicit RoomRays(const Distribution& distribution);
  // The shares of the flux that luminaires in the ceiling plane send to each surface straight: of a regular array with
  // columns * rows of them, the outer ones half a spacing from the walls, or, with 0, spread evenly. C0 is along x.
  RoomFlux direct_shares(const RoomShape& room, int columns, int rows) const;

 private:
  struct Ray {
    double dx, dy;  // where it meets the reference plane, from its luminaire
  };
  std::vector<Ray> down_;
  double share_ = 0, up_ = 0;  // of one ray, of all upward ones
};

}  // namespace photometry
