// What ups_photometry.h computes of a profile: beams, zonal flux, luminance, and the fields of ups_profile_info that
// rest on them. The numbers themselves are tested in tests/photometry; here the interface and its errors.
#include <cmath>

#include "fixture.h"

namespace ups_test {
namespace {

class ProfileMetrics : public Api {
 protected:
  // Axially symmetric: 100 cd down to 0 at 90 degrees along a line, a tenth of it upwards; a disc of 0.2 m.
  ProfileMetrics() {
    auto d = make(&ups_profile_desc_init);
    d.c_count = 1, d.gamma_count = 4;
    d.c_deg = c, d.gamma_deg = gamma, d.intensity_cd = cd;
    d.opening_shape = UPS_OPENING_DISC;
    d.opening_m[0] = d.opening_m[1] = 0.2f;
    EXPECT_OK(ups_profile_create(context, &d, &lamp));
  }
  ~ProfileMetrics() override { ups_profile_destroy(lamp); }

  const float c[1] = {0}, gamma[4] = {0, 90, 90.5f, 180}, cd[4] = {100, 0, 10, 10};
  ups_profile* lamp = nullptr;
};

TEST_F(ProfileMetrics, Beam) {
  ups_profile_beam beam{};
  beam.struct_size = sizeof beam;
  EXPECT_OK(ups_profile_get_beam(lamp, 0, 0.5f, &beam));
  EXPECT_NEAR(beam.angle_deg, 90, 1e-4);
  EXPECT_NEAR(beam.from_deg, -45, 1e-4);
  EXPECT_NEAR(beam.to_deg, 45, 1e-4);
  EXPECT_EQ(beam.peak_cd, 100);
  EXPECT_EQ(beam.peak_deg, 0);
  ups_profile_info info{};
  info.struct_size = sizeof info;
  EXPECT_OK(ups_profile_get_info(lamp, &info));
  for (int plane = 0; plane < 2; ++plane) {
    EXPECT_EQ(info.beam_angle_deg[plane], beam.angle_deg);
    EXPECT_NEAR(info.field_angle_deg[plane], 162, 1e-4);
  }
  expect_error(ups_profile_get_beam(nullptr, 0, 0.5f, &beam), UPS_ERROR_INVALID_ARGUMENT, {"profile is NULL"});
  expect_error(ups_profile_get_beam(lamp, NAN, 0.5f, &beam), UPS_ERROR_INVALID_ARGUMENT, {"c_deg"});
  expect_error(ups_profile_get_beam(lamp, 0, 0, &beam), UPS_ERROR_INVALID_ARGUMENT, {"fraction", "greater than 0"});
  expect_error(ups_profile_get_beam(lamp, 0, 1.5f, &beam), UPS_ERROR_INVALID_ARGUMENT, {"fraction", "1.5"});
  expect_error(ups_profile_get_beam(lamp, 0, 0.5f, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"beam"});
  beam.struct_size = 0;
  expect_error(ups_profile_get_beam(lamp, 0, 0.5f, &beam), UPS_ERROR_INVALID_ARGUMENT, {"struct_size"});
}

TEST_F(ProfileMetrics, ZonalFlux) {
  const float edges[4] = {0, 60, 90, 180};
  double flux[3] = {};
  EXPECT_OK(ups_profile_get_zonal_flux(lamp, edges, 4, flux));
  const double pi = std::acos(-1.0);  // the one band from 0 to 90 has 50 cd
  EXPECT_NEAR(flux[0], 50 * pi, 1e-3);
  EXPECT_NEAR(flux[1], 50 * pi, 1e-3);
  ups_profile_info info{};
  info.struct_size = sizeof info;
  EXPECT_OK(ups_profile_get_info(lamp, &info));
  EXPECT_NEAR(flux[0] + flux[1] + flux[2], info.flux_lm, 1e-6);
  EXPECT_NEAR(info.down_flux_lm, flux[0] + flux[1], 1e-6);
  EXPECT_NEAR(info.up_flux_lm, flux[2], 1e-6);
  EXPECT_LT(info.light_output_ratio, 0);
  const auto expect = [&](const float(&bad)[2], const std::vector<std::string>& words) {
    expect_error(ups_profile_get_zonal_flux(lamp, bad, 2, flux), UPS_ERROR_INVALID_ARGUMENT, words);
  };
  expect({-1, 90}, {"gamma_deg", "element 0"});
  expect({0, 181}, {"gamma_deg", "element 1", "181"});
  expect({0, NAN}, {"gamma_deg", "element 1"});
  expect({90, 90}, {"element 1", "not greater"});
  expect_error(ups_profile_get_zonal_flux(lamp, edges, 1, flux), UPS_ERROR_INVALID_ARGUMENT, {"count is 1"});
  expect_error(ups_profile_get_zonal_flux(lamp, nullptr, 2, flux), UPS_ERROR_INVALID_ARGUMENT, {"gamma_deg is NULL"});
  expect_error(ups_profile_get_zonal_flux(lamp, edges, 2, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"flux_lm is NULL"});
}

TEST_F(ProfileMetrics, Luminance) {
  const float directions[9] = {0, 0, -2, 1, 0, -1, 1, 0, 0};
  float luminance[3] = {};
  EXPECT_OK(ups_profile_get_luminance(lamp, directions, 3, luminance));
  const double area = std::acos(-1.0) * 0.01;
  EXPECT_NEAR(luminance[0], 100 / area, 0.01);
  EXPECT_NEAR(luminance[1], 50 / (area * std::sqrt(0.5)), 0.01);
  EXPECT_LT(luminance[2], 0);
  EXPECT_OK(ups_profile_get_luminance(profile, directions, 1, luminance));  // of a point
  EXPECT_LT(luminance[0], 0);
  const float nowhere[3] = {0, 0, 0};
  expect_error(ups_profile_get_luminance(lamp, nowhere, 1, luminance), UPS_ERROR_INVALID_ARGUMENT,
               {"directions_xyz", "element 0"});
  expect_error(ups_profile_get_luminance(lamp, nullptr, 1, luminance), UPS_ERROR_INVALID_ARGUMENT,
               {"directions_xyz is NULL"});
  expect_error(ups_profile_get_luminance(lamp, directions, 1, nullptr), UPS_ERROR_INVALID_ARGUMENT,
               {"luminance_cd_m2 is NULL"});
}

}  // namespace
}  // namespace ups_test
