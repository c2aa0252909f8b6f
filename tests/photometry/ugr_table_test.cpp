// UGR tables: against the factors that CIE 190 prints, and against a calculation of another make that is done here,
// point by point. A rendered room is in tests/analytic/observer_test.cpp.
#include "photometry/ugr_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "photometry/cie190_factors.h"
#include "photometry/files.h"
#include "photometry/metrics.h"
#include "photometry/position_index.h"

namespace photometry {
namespace {

constexpr double pi = 3.14159265358979323846;
using test::rad;
using test::steps;

Photometry panel(const std::function<double(double, double)>& intensity, double width = 0.6, double length = 1.2) {
  const std::vector<double> c = steps(0, 350, 35), g = steps(0, 180, 180);
  std::vector<double> table;
  for (double c_deg : c)
    for (double g_deg : g) table.push_back(intensity(c_deg, g_deg));
  Photometry p{Distribution(c, g, std::move(table))};
  p.opening.shape = OpeningShape::rectangle;
  p.opening.size_m[0] = float(width), p.opening.size_m[1] = float(length);
  return p;
}

double lambertian(double, double g) { return g < 90 ? 1000 * std::cos(rad(g)) : 0; }
double batwing(double c, double g) {
  return g < 80 ? (600 + 300 * std::cos(rad(2 * c)) * std::sin(rad(g)) + 500 * std::sin(rad(2 * g))) : 0;
}
double spot(double, double g) { return g < 90 ? 5000 * std::pow(std::cos(rad(g)), 8) : 0; }
double pendant(double c, double g) {
  return (g < 90 ? 700 : 400) * std::abs(std::cos(rad(g))) * (1 - 0.2 * std::cos(rad(2 * c)) * std::sin(rad(g)));
}

// What the walls get from interreflection: 285 factors that CIE 190 prints to three digits, but one that is printed as
// 0.158 for 0.1593.
TEST(Room, HasTheTransferFactorsOfCie190) {
  for (int r = 0; r < UgrTable::rooms; ++r) {
    for (int k = 0; k < UgrTable::reflectance_sets; ++k) {
      for (int s = 0; s < 3; ++s) {
        RoomFlux direct{};
        direct[size_t(s)] = 1;
        const RoomFlux all = exchange(UgrTable::shapes[r], UgrTable::reflectances[k], direct);
        EXPECT_NEAR(all[1] - direct[1], test::cie190_transfer[k][r][s], 0.0013) << r << " " << k << " " << s;
      }
    }
  }
}

TEST(Room, KeepsAllLightWhereNothingAbsorbs) {
  const RoomShape room{3, 5};
  const Reflectances rho{0.999999, 0.999999, 0.999999};
  const RoomFlux all = exchange(room, rho, {0.4, 0.1, 0.5});
  EXPECT_NEAR((all[0] + all[1] + all[2]) * 1e-6, 1, 1e-5);  // absorbed
  EXPECT_NEAR(all[0] / room.floor_area(), all[1] / room.wall_area(), 1e-4 * all[0] / room.floor_area());
}

// The direct part, point by point: the floor's illuminance under every luminaire.
double floor_share_by_points(const Photometry& p, const RoomShape& room, double spacing, int points_per_spacing) {
  const int nx = int(std::lround(room.x / spacing)), ny = int(std::lround(room.y / spacing));
  const int px = nx * points_per_spacing, py = ny * points_per_spacing;
  double flux = 0;
  for (int i = 0; i < px; ++i) {
    for (int j = 0; j < py; ++j) {
      const double x = (i + 0.5) * room.x / px, y = (j + 0.5) * room.y / py;
      for (int a = 0; a < nx; ++a)
        for (int b = 0; b < ny; ++b) {
          const double dx = x - (a + 0.5) * spacing, dy = y - (b + 0.5) * spacing, r2 = dx * dx + dy * dy + 1;
          flux += p.distribution.eval(dx, dy, -1) / (r2 * std::sqrt(r2));
        }
    }
  }
  return flux * room.x * room.y / (double(px) * py) / (nx * ny * flux_lm(p));
}

TEST(Room, DirectSharesAreThosePointByPoint) {
  for (const auto& f : {lambertian, batwing, spot, pendant}) {
    const Photometry p = panel(f);
    const RoomRays rays(p.distribution);
    for (const RoomShape& room : {RoomShape{2, 2}, {4, 2}, {2, 3}}) {
      const RoomFlux direct = rays.direct_shares(room, int(4 * room.x), int(4 * room.y));
      EXPECT_NEAR(direct[0], floor_share_by_points(p, room, 0.25, 4), 0.003) << room.x << " " << room.y;
      EXPECT_NEAR(direct[0] + direct[1] + direct[2], 1, 1e-12);
      EXPECT_NEAR(direct[2], zonal_flux_lm(p, 90, 180, FluxRule::interpolated) / flux_lm(p), 0.002);
    }
  }
}

// The sum over the luminaires, written down anew: by angles, with CIE 117's own C and gamma (its equations 4.4 to 4.8).
double glare_sum(const Photometry& p, const RoomShape& room, bool endwise) {
  double sum = 0;
  const double h = 2, area = double(p.opening.size_m[0]) * double(p.opening.size_m[1]);
  for (double r = h / 8; r < room.y * h; r += h / 4) {
    for (double t = h / 8; t < room.x * h / 2; t += h / 4) {
      const double index = position_index(PositionIndex::table, t / r, h / r, 1);
      if (index < 0) continue;
      const double gamma = std::atan(std::hypot(r, t) / h), aside = std::atan(t / r);
      const double d2 = r * r + t * t + h * h, projected = area * std::cos(gamma);
      for (const double c : {endwise ? pi / 2 - aside : -aside, endwise ? pi / 2 + aside : aside}) {
        const double intensity = p.distribution.eval(std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c),
                                                     -std::cos(gamma));
        sum += std::pow(intensity / projected, 2) * projected / d2 / (index * index);
      }
    }
  }
  return sum;
}

// Its zones' flux, once for all rooms.
struct Zones {
  double floor[4];  // of CIE 190's table 4
  double lower, upper;
  explicit Zones(const Photometry& p)
      : lower(zonal_flux_lm(p, 0, 90, FluxRule::band)), upper(zonal_flux_lm(p, 90, 180, FluxRule::band)) {
    const double edges[4] = {std::acos(0.75) * 180 / pi, 60, std::acos(0.25) * 180 / pi, 90};
    for (int i = 0; i < 4; ++i) floor[i] = zonal_flux_lm(p, 0, edges[i], FluxRule::band);
  }
};

// From the flux that reaches floor and walls straight: what the walls get of it, by CIE 190's table 5.
double background_of(const Zones& zones, double floor, int room, int reflectances) {
  const double* f = test::cie190_transfer[reflectances][room];
  const RoomShape& shape = UgrTable::shapes[room];
  const double luminaires = 16 * shape.floor_area(), wall_m2 = 4 * shape.wall_area();
  return (floor * f[0] + (zones.lower - floor) * f[1] + zones.upper * f[2]) * luminaires / wall_m2 / pi;
}

// As CIE 190 prints it: by its table 4.
double floor_by_cie190(const Zones& zones, int room) {
  const double* weight = nullptr;
  for (const auto& z : test::cie190_zonal)
    if (std::abs(z.room_index - UgrTable::shapes[room].index()) < 0.006) weight = z.weight;
  EXPECT_NE(weight, nullptr) << room;
  double floor = 0;
  for (int i = 0; i < 4; ++i) floor += weight[i] * zones.floor[i];
  return floor;
}

void expect_cie190s_table(const Photometry& p, double bound, const std::string& name) {
  const UgrTable table = ugr_table(p);
  const Zones zones(p);
  for (int view = 0; view < 2; ++view)
    for (int r = 0; r < UgrTable::rooms; ++r) {
      const double glare = glare_sum(p, UgrTable::shapes[r], view == 1), floor = floor_by_cie190(zones, r);
      for (int k = 0; k < UgrTable::reflectance_sets; ++k)
        EXPECT_NEAR(table.ugr[view][r][k], 8 * std::log10(0.25 / background_of(zones, floor, r, k) * glare), bound)
            << name << ": " << view << " " << r << " " << k;
    }
}

// Sums over luminaires agree exactly. The floor's direct light by four zones, for a spacing of H, is that of the array
// with H / 4 to a few per cent: ratings within 0.1, of a narrow spot within 0.22 (the zones' error, see below).
TEST(UgrTable, IsThatOfCie190sTables) {
  expect_cie190s_table(panel(lambertian), 0.1, "lambertian");
  expect_cie190s_table(panel(batwing), 0.1, "batwing");
  expect_cie190s_table(panel(pendant), 0.1, "pendant");
  expect_cie190s_table(panel(spot), 0.22, "spot");
}

// Of files with a rectangular opening, some of them one-sided: as above.
TEST(UgrTable, OfFilesIsThatOfCie190sTables) {
  for (const char* name : {"l01_isym1.ldt", "l03_isym0_asym.ldt", "l04_isym3.ldt", "l05_isym3_absolute.ldt",
                           "l06_cfli_2.ldt", "s01_lm63_1986.ies", "s02_iesna91_blpf_0p95.ies", "s03_lm63_1995.ies",
                           "s05_lm63_2019_filegen_1p1.ies", "s08_typeC_asym.ies", "s09_typeB_asym.ies",
                           "s10_typeA_asym.ies", "s17_isotropic_10000lm.ies", "s18_90_270.ies"}) {
    const Photometry p = test::read_file(name);
    ASSERT_EQ(p.opening.shape, OpeningShape::rectangle) << name;
    expect_cie190s_table(p, 0.1, name);
  }
}

// The floor's direct light point by point instead: no zones, so the narrow spot's ratings are within 0.1, too.
TEST(UgrTable, IsThatOfDirectLightPointByPoint) {
  for (const auto& f : {lambertian, batwing, pendant, spot}) {
    const Photometry p = panel(f);
    const UgrTable table = ugr_table(p);
    const Zones zones(p);
    for (const int r : {0, 2, 6, 8, 10, 12, 14})
      for (int view = 0; view < 2; ++view) {
        const RoomShape& room = UgrTable::shapes[r];
        const RoomShape in_frame = view == 0 ? RoomShape{room.y, room.x} : room;  // C0 along the first side
        const double floor = flux_lm(p) * floor_share_by_points(p, in_frame, 0.25, 2),
                     glare = glare_sum(p, room, view == 1);
        for (int k = 0; k < UgrTable::reflectance_sets; ++k)
          EXPECT_NEAR(table.ugr[view][r][k], 8 * std::log10(0.25 / background_of(zones, floor, r, k) * glare), 0.1)
              << view << " " << r << " " << k;
      }
  }
}

// 0.1 degrees wide: to the floor, or past it to a wall.
TEST(Room, MissesNoNeedle) {
  for (const double gamma : {20.3, 80.3}) {
    const Distribution needle({0, 10, 10.1, 10.2}, {gamma, gamma + 0.05, gamma + 0.1},
                              {0, 0, 0, 0, 0, 0, 0, 1000, 0, 0, 0, 0});
    const RoomFlux direct = RoomRays(needle).direct_shares({2, 2}, 0, 0);
    const double reach = std::tan(rad(gamma + 0.05));
    const double dx = reach * std::cos(rad(10.1)), dy = reach * std::sin(rad(10.1));
    const double floor = std::max(0.0, 1 - dx / 2) * std::max(0.0, 1 - dy / 2);
    EXPECT_NEAR(direct[0], floor, 1e-3) << gamma;
    EXPECT_NEAR(direct[1], 1 - floor, 1e-3) << gamma;
  }
}

TEST(UgrTable, RisesWithTheFluxAndHasTheLampsFlux) {
  Photometry p = panel(lambertian);
  const UgrTable one = ugr_table(p);
  EXPECT_NEAR(one.lamp_flux_lm, flux_lm(p), 1e-9);
  p.rated_flux_lm = 4000;
  EXPECT_EQ(ugr_table(p).lamp_flux_lm, 4000);
  Photometry twice = panel([](double c, double g) { return 2 * lambertian(c, g); });
  EXPECT_NEAR(ugr_table(twice).ugr[1][10][0] - one.ugr[1][10][0], 8 * std::log10(2.0), 1e-9);
}

TEST(UgrTable, CrosswiseFacesC0) {
  // Light towards C0 and C180 alone dazzles crosswise.
  const Photometry p = panel([](double c, double g) { return lambertian(c, g) * (1 + 0.9 * std::cos(rad(2 * c))); });
  const UgrTable table = ugr_table(p);
  EXPECT_GT(table.ugr[0][5][0], table.ugr[1][5][0] + 3);
}

// Wherever a file has its long side: as EULUMDAT along C90, or as IES along C0.
TEST(UgrTable, CrosswiseIsAcrossTheLongSide) {
  const auto linear = [](bool along_c0) {
    const double turn = along_c0 ? 180 : 0;
    Photometry p = panel([=](double c, double g) { return lambertian(c, g) * (1 + 0.9 * std::cos(rad(2 * c + turn))); });
    p.opening.size_m[0] = along_c0 ? 1.5f : 0.1f, p.opening.size_m[1] = along_c0 ? 0.1f : 1.5f;
    return ugr_table(p);
  };
  const UgrTable as_eulumdat = linear(false), as_ies = linear(true);
  EXPECT_GT(as_eulumdat.ugr[0][10][0], as_eulumdat.ugr[1][10][0] + 3);
  for (int view = 0; view < 2; ++view)
    EXPECT_NEAR(as_ies.ugr[view][10][0], as_eulumdat.ugr[view][10][0], 0.05) << view;
}

// Where the opening does not tell, the format does: TM-33 has its length along C90, as EULUMDAT (before: as LM-63).
TEST(UgrTable, OfASquareOpeningTheFormatTellsWhatIsAcross) {
  Photometry p = panel([](double c, double g) { return lambertian(c, g) * (1 + 0.9 * std::cos(rad(2 * c))); }, 0.6, 0.6);
  const auto crosswise = [&](const char* format) { return p.format = format, ugr_table(p).ugr[0][5][0]; };
  EXPECT_EQ(crosswise("IES TM-33-18"), crosswise("EULUMDAT"));
  EXPECT_GT(crosswise("EULUMDAT"), crosswise("IES LM-63-2002") + 3);
}

TEST(UgrTable, SaysWhereThereIsNoGlareAndNoOpening) {
  const UgrTable up = ugr_table(panel([](double, double g) { return g > 91 ? 500.0 : 0; }));
  EXPECT_EQ(up.ugr[0][0][0], UgrTable::no_glare);
  Photometry point = panel(lambertian);
  point.opening = {};
  EXPECT_THROW(ugr_table(point), UnsupportedError);
  point.opening.shape = OpeningShape::rectangle;
  point.opening.size_m[1] = 1.2f;  // a line
  EXPECT_THROW(ugr_table(point), UnsupportedError);
  EXPECT_THROW(ugr_table(panel([](double, double) { return 0.0; })), std::invalid_argument);
}

}  // namespace
}  // namespace photometry
