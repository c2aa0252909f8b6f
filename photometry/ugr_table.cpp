#include "photometry/ugr_table.h"

#include <cmath>
#include <stdexcept>

#include "photometry/metrics.h"
#include "photometry/position_index.h"
#include "photometry/ugr.h"

namespace photometry {
namespace {

constexpr double pi = 3.14159265358979323846;

bool has_area(const Opening& o) {
  return projected_area_m2(o, 1, 0, 0) > 0 || projected_area_m2(o, 0, 1, 0) > 0 || projected_area_m2(o, 0, 0, 1) > 0;
}

// The C plane that faces who looks across the luminaire's long side: EULUMDAT has that along C90, IES type C along C0.
// Where the opening does not tell, the format does.
bool crosswise_is_c90(const Photometry& p) {
  const double x = double(p.opening.size_m[0]), y = double(p.opening.size_m[1]);
  if (std::abs(x - y) > 0.01 * std::max(x, y)) return x > y;
  return p.format.rfind("IES LM-63", 0) == 0 && p.type == PhotometricType::c;
}

// Of all luminaires of a room; plain, without CIE 147. faces_c0: C0 is turned to the eye, else C90.
double sum_of_terms(const Photometry& photometry, const RoomShape& room, bool faces_c0) {
  constexpr double h = UgrTable::height_m, step = UgrTable::spacing * h;
  const int columns = int(std::lround(room.x / UgrTable::spacing)), rows = int(std::lround(room.y / UgrTable::spacing));
  double sum = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double right = (i + 0.5 - 0.5 * columns) * step, forward = (j + 0.5) * step;
      const double p = position_index(PositionIndex::table, right, h, forward);
      if (p < 0) continue;
      // From the luminaire to the eye, in its own frame: C0 or C90 faces the wall with the eye.
      const double x = faces_c0 ? forward : right, y = faces_c0 ? -right : forward;
      const double luminance = luminance_cd_m2(photometry, x, y, -h);
      if (!(luminance > 0)) continue;
      const double solid_angle = projected_area_m2(photometry.opening, x, y, -h) / (x * x + y * y + h * h);
      sum += luminance * luminance * solid_angle / (p * p);
    }
  }
  return sum;
}

}  // namespace

UgrTable ugr_table(const Photometry& photometry) {
  if (!has_area(photometry.opening))
    throw UnsupportedError("the luminous opening has no area, so no luminance to rate: a UGR table needs a file that "
                           "states an opening of two extents at least");
  const double flux = flux_lm(photometry);
  const RoomRays rays(photometry.distribution);
  UgrTable table;
  const double lamps = lamp_flux_lm(photometry);
  table.lamp_flux_lm = lamps > 0 ? lamps : flux;
  const bool turned = crosswise_is_c90(photometry);
  for (int view = 0; view < UgrTable::views; ++view) {
    const bool faces_c0 = (view == 0) != turned;
    for (int r = 0; r < UgrTable::rooms; ++r) {
      const RoomShape& room = UgrTable::shapes[r];
      const double sum = sum_of_terms(photometry, room, faces_c0);
      const int nx = int(std::lround(room.x / UgrTable::spacing)), ny = int(std::lround(room.y / UgrTable::spacing));
      const RoomFlux direct =  // C0 along the first side
          faces_c0 ? rays.direct_shares({room.y, room.x}, ny, nx) : rays.direct_shares(room, nx, ny);
      const double wall_m2 = room.wall_area() * UgrTable::height_m * UgrTable::height_m;
      for (int k = 0; k < UgrTable::reflectance_sets; ++k) {
        const RoomFlux all = exchange(room, UgrTable::reflectances[k], direct);
        const double indirect_lx = (all[1] - direct[1]) * flux * nx * ny / wall_m2;
        table.ugr[view][r][k] = sum > 0 ? ugr(sum, indirect_lx / pi) : UgrTable::no_glare;
      }
    }
  }
  return table;
}

}  // namespace photometry
