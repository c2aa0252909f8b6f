// Profiles, fixtures and what needs no scene: the photometry of ups.hpp.
#include <cmath>
#include <cstddef>

#include "room.h"

namespace {

const std::string ies =
    "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] 2026-01-01\n[MANUFAC] maker\nTILT=NONE\n"
    "1 -1 1 4 1 1 2 0.3 0.3 0\n1 1 20\n0 30 60 90\n0\n1000 740 190 0\n";

TEST(Profiles, AreReadAskedAndWritten) {
  ups::Context context(two_threads());
  const ups::Profile profile = ups::Profile::parse(context, ies);
  EXPECT_EQ(profile.get_info().peak_cd, 1000);
  EXPECT_EQ(profile.get_keyword("MANUFAC"), "maker");
  EXPECT_EQ(profile.get_text(UPS_PROFILE_TEXT_FORMAT), "IES LM-63-2002");
  EXPECT_EQ(profile.lamp_sets().size(), profile.get_info().lamp_set_count);
  const std::string written = profile.with_keyword("LUMCAT", "number 7").write(UPS_PROFILE_IES_LM63);
  EXPECT_NE(written.find("number 7"), std::string::npos);
  EXPECT_EQ(written.back(), '\n') << "the final zero is no part of the file";
  EXPECT_EQ(profile.get_write_warnings(UPS_PROFILE_IES_LM63), "");

  std::vector<std::byte> bytes;
  for (const char c : written) bytes.push_back(static_cast<std::byte>(c));
  ups::ProfileParseDesc desc;
  desc.bytes = bytes.data();
  desc.size = bytes.size();
  EXPECT_EQ(ups::Profile::parse_with(context, desc).get_info().flux_lm, profile.get_info().flux_lm);
  EXPECT_EQ(ups::Profile::parse(context, bytes, UPS_PROFILE_IES_LM63).get_keyword("LUMCAT"), "number 7");
}

TEST(Profiles, AnswerForDirectionsAndAngles) {
  ups::Context context(two_threads());
  const ups::Profile profile = ups::Profile::parse(context, ies);
  const float directions[] = {0, 0, -1, 1, 0, 0, 0, 0, 1};
  const std::vector<float> intensity = profile.eval(directions), luminance = profile.get_luminance(directions);
  ASSERT_EQ(intensity.size(), 3u);
  EXPECT_NEAR(intensity[0], 1000, 1e-3);
  EXPECT_EQ(intensity[2], 0);
  EXPECT_NEAR(luminance[0], 1000 / 0.09, 1);
  const std::vector<double> zones = profile.get_zonal_flux(std::vector<float>{0, 60, 180});
  ASSERT_EQ(zones.size(), 2u);
  EXPECT_NEAR(zones[0] + zones[1], profile.get_info().flux_lm, 1e-6);
  EXPECT_GT(profile.get_beam(0, 0.5f).angle_deg, 60);
  EXPECT_GT(profile.get_ugr_table().crosswise[0], 0);
  EXPECT_EQ(profile.get_data_sheet().flux_code[3], 100) << "all of it downwards";
  EXPECT_GT(profile.get_utilisation().factors[0], 0);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"directions", "4 values", "multiple of 3"},
               [&] { profile.eval(std::vector<float>(4)); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"intensities_cd", "3 values; expected 2"},
               [&] { ups::ProfileDesc(std::vector<float>(1), std::vector<float>(2), std::vector<float>(3)); });
}

TEST(Fixtures, AreBuiltPlacedAndEdited) {
  ups::Context context(two_threads());
  ups::Fixture fixture(context);
  ups::FixtureEmitterDesc cob;
  cob.radius_m = 0.0045;
  cob.flux_lm = 1000;
  const auto emitter = fixture.add_emitter(cob);
  ups::ReflectorDesc cup;
  cup.focal_length_m = 0.006;
  cup.inner_radius_m = 0.006;
  cup.aperture_radius_m = 0.035;
  fixture.add_reflector(cup);
  const double wall_rz[] = {0.036, 0, 0.036, -0.05};
  fixture.add_reflector(ups::ReflectorDesc(wall_rz));
  ups::LensDesc cover;
  cover.finish = UPS_FINISH_PMMA;
  cover.radius_m = 0.03;
  cover.thickness_m = 0.003;
  ups::Transform::translation(0, 0, -0.06).copy_to(cover.to_fixture);
  fixture.add_lens(cover);
  const float ring[] = {-0.1f, -0.1f, -0.2f, 0.1f, -0.1f, -0.2f, 0, 0.1f, -0.2f};
  const std::uint32_t triangle[] = {0, 1, 2};
  const ups::MeshDesc mesh(ring, triangle, {});
  ups::FixturePartDesc part(mesh);
  part.finish = UPS_FINISH_BLACK;
  fixture.add_part(part);
  EXPECT_EQ(fixture.get_info().part_count, 5u);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {}, [&] { fixture.add_collimator(ups::CollimatorDesc()); });

  ups::Scene scene(context);
  const auto placed = scene.add_fixture(fixture, ups::FixtureInstanceDesc(ups::Transform::translation(0, 0, 2)));
  EXPECT_NE(scene.get_fixture_instance(placed, emitter).v, 0u);
  scene.set_fixture_dimming(placed, 0.5f);
  scene.set_fixture_transform(placed, ups::Transform::translation(0, 0, 3));
  ups::FixtureInstanceDesc desc = scene.get_fixture(placed);
  EXPECT_EQ(desc.dimming, 0.5f);
  EXPECT_EQ(desc.to_world[11], 3);
  desc.flux_lm = 600;
  scene.set_fixture(placed, desc);
  scene.commit();
  EXPECT_NEAR(scene.get_info().emitted_flux_lm, 300, 1e-3);
  scene.remove_fixture(placed);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"removed"}, [&] { scene.get_fixture(placed); });
}

TEST(Standards, GridsOfEn12464LeaveHolesOut) {
  const double corners[] = {0, 0, 6, 0, 6, 4, 0, 4}, hole[] = {2, 1, 3, 1, 3, 3, 2, 3};
  ups::En12464Desc desc(corners);
  const auto whole = ups::en12464_grid(desc);
  EXPECT_EQ(whole.points.size(), whole.info.point_count);
  EXPECT_EQ(whole.info.columns * whole.info.rows, whole.info.point_count);
  const std::uint32_t counts[] = {4};
  desc.set_holes(hole, counts);
  EXPECT_LT(ups::en12464_grid(desc).points.size(), whole.points.size());
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"corners", "7 values; expected 8"},
               [&] { desc.set_holes({hole, 7}, counts); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"corners", "multiple of 2"}, [&] { ups::En12464Desc({corners, 7}); });
}

TEST(Standards, UgrIsThatOfTheFormula) {
  const float directions[] = {0, 0, -1, 0, 0, 1};
  const auto index = ups::glare_get_position_index(UPS_POSITION_INDEX_GUTH, directions);
  ASSERT_EQ(index.size(), 2u);
  EXPECT_NEAR(index[0], 1, 1e-3);
  EXPECT_EQ(index[1], -1) << "behind the eye";
  const float luminance[] = {10000}, solid_angle[] = {0.01f}, position[] = {2};
  EXPECT_NEAR(ups::glare_get_ugr(luminance, solid_angle, position, 20),
              8 * std::log10(0.25 / 20 * 1e8 * 0.01 / 4), 1e-3);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"solid_angle_sr"},
               [&] { ups::glare_get_ugr(luminance, {}, position, 20); });
}

}  // namespace
