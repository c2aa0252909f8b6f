// Do the readers of ray files find every column, convert every unit and refuse what they cannot read? Files are made in
// memory, by the layouts of their formats.
#include <gtest/gtest.h>

#include "photometry/files.h"
#include "photometry/luminosity.h"
#include "support/ray_bytes.h"

namespace ups::test {
namespace {

using photometry::ParseError;
using photometry::Photometry;
using photometry::UnsupportedError;
using photometry::test::expect_refused;
using photometry::test::warned;

Photometry read(const std::string& bytes) { return photometry::test::read_text(bytes); }

double total(const Photometry& p) {
  double sum = 0;
  for (const photometry::Ray& r : p.rays) sum += r.flux_lm;
  return sum;
}

void expect_ray(const photometry::Ray& r, std::initializer_list<double> p_m, std::initializer_list<double> d,
                double lm) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(r.p_m[k], p_m.begin()[k], 1e-6);
    EXPECT_NEAR(r.direction[k], d.begin()[k], 1e-6);
  }
  EXPECT_NEAR(r.flux_lm, lm, 1e-5 * lm);
}

const std::vector<FileRay> two_rays = {{{1, -2, 3}, {0, 0, -1}, 2}, {{10, 0, 0}, {0.6, 0, 0.8}, 6}};

TEST(RayFile, Tm25WithLuminousFlux) {
  Tm25Header header;
  header.name = "Lamp", header.maker = "Maker";
  const Photometry p = read(tm25_bytes(two_rays, header));
  ASSERT_EQ(p.rays.size(), 2u);
  expect_ray(p.rays[0], {0.001, -0.002, 0.003}, {0, 0, -1}, 2);
  expect_ray(p.rays[1], {0.01, 0, 0}, {0.6, 0, 0.8}, 6);
  EXPECT_EQ(p.format, "IES TM-25");
  ASSERT_EQ(p.keywords.size(), 3u);
  EXPECT_EQ(p.keywords[0].name, "TESTDATE");
  EXPECT_EQ(p.keywords[0].value, "2026-01-01T00:00:00+00:00");
  EXPECT_EQ(p.keywords[1].value, "Lamp");
  EXPECT_EQ(p.keywords[2].name, "MANUFAC");
  EXPECT_EQ(p.keywords[2].value, "Maker");
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_EQ(p.warnings[0], "the table of intensities is a sample of 2 rays, with a noise of about 100 % a node");
  EXPECT_NEAR(p.distribution.interpolated_flux_lm(), 8, 1e-9);
}

TEST(RayFile, Tm25ScalesToItsHeader) {
  Tm25Header header;
  header.luminous_lm = 100;
  const Photometry p = read(tm25_bytes(two_rays, header));
  expect_ray(p.rays[0], {0.001, -0.002, 0.003}, {0, 0, -1}, 25);
  EXPECT_NEAR(total(p), 100, 1e-4);
  EXPECT_TRUE(warned(p, "add up to 8 lm; they are scaled to the header's 100 lm"));
  for (double odd : {-5.0, std::numeric_limits<double>::infinity()}) {
    header.luminous_lm = odd;
    EXPECT_NEAR(total(read(tm25_bytes(two_rays, header))), 8, 1e-6);
    EXPECT_TRUE(warned(read(tm25_bytes(two_rays, header)), "the rays are not scaled to it")) << odd;
  }
  header.luminous_lm = 8;
  EXPECT_EQ(read(tm25_bytes(two_rays, header)).warnings.size(), 1u);
}

// Every kind of column, and all that stands between the header and the rays.
TEST(RayFile, Tm25SkipsWhatItDoesNotNeed) {
  Tm25Header h;
  h.radiant = h.wavelength = h.stokes = h.tristimulus = h.spectrum = true;
  h.rays = 2, h.tables = 2, h.additional = 2, h.text_size = 32, h.spectral = 4;
  ByteWriter w = tm25_header(h);
  w.u32(2).f32({500, 1, 600, 1}).u32(1).f32({555, 1});
  const size_t used = w.size() - 36288;
  w.pad_to(36288 + (used + 31) / 32 * 32);
  w.pad_to(w.size() + 2 * 512 + 32);
  for (int i = 0; i < 2; ++i) w.f32({double(i), 0, 0, 0, 0, -1, 7, 555, 3.0 + i, 1, 2, 3, 4, 5, 6, 8, 9, 0, 11, 12});
  const Photometry p = read(w.bytes());
  ASSERT_EQ(p.rays.size(), 2u);
  expect_ray(p.rays[1], {0.001, 0, 0}, {0, 0, -1}, 4);
  EXPECT_NEAR(total(p), 7, 1e-5);
}

std::string radiant_file(Tm25Header h, double flux, double extra) {
  h.luminous = false, h.radiant = true, h.rays = 1;
  ByteWriter w = tm25_header(h);
  if (h.tables == 2) w.u32(1).f32({555, 1}).u32(2).f32({650, 1, 660, 1}).pad_to(36288 + 32);
  if (h.tables == 1) w.u32(2).f32({540, 2, 560, 2}).pad_to(36288 + 32);
  w.f32({0, 0, 0, 0, 0, -1, flux});
  if (h.wavelength || h.spectrum) w.f32({extra});
  return w.bytes();
}

TEST(RayFile, Tm25TurnsWattsIntoLumens) {
  Tm25Header wavelength;
  wavelength.wavelength = true;
  const Photometry by_ray = read(radiant_file(wavelength, 2, 555));
  EXPECT_NEAR(total(by_ray), 2 * 683, 1e-3);
  EXPECT_TRUE(warned(by_ray, "683 lm/W V(lambda)"));

  Tm25Header single;
  single.spectral = 1, single.wavelength_nm = 600;
  EXPECT_NEAR(total(read(radiant_file(single, 1, 0))), 683 * 0.631, 1e-3);

  Tm25Header spectrum;
  spectrum.spectral = 3, spectrum.tables = 1;
  // The mean of V over the table's steps from 540 to 560 nm, by trapezoids: V is linear between them.
  const double mean = (0.5 * 0.954 + 0.9803 + 0.99495 + 1 + 0.5 * 0.995) / 4;
  EXPECT_NEAR(total(read(radiant_file(spectrum, 1, 0))), 683 * mean, 1e-3);

  Tm25Header spectra;
  spectra.spectral = 4, spectra.tables = 2, spectra.spectrum = true;
  EXPECT_NEAR(total(read(radiant_file(spectra, 3, 1))), 3 * 683, 1e-2);
  EXPECT_NEAR(total(read(radiant_file(spectra, 3, 2))), 3 * 683 * ((0.107 + 0.0816) / 4 + (0.0816 + 0.061) / 4), 1e-2);
  expect_refused<ParseError>(radiant_file(spectra, 3, 0), "has the spectrum 0; the file has 2, counted from 1");
  expect_refused<ParseError>(radiant_file(spectra, 3, 3), "has the spectrum 3; the file has 2");

  Tm25Header header_alone;
  header_alone.luminous_lm = 40;
  const Photometry alone = read(radiant_file(header_alone, 3, 0));
  EXPECT_NEAR(total(alone), 40, 1e-4);
  EXPECT_TRUE(warned(alone, "all rays are taken to have the same one"));

  Tm25Header watts = wavelength;
  watts.radiant_w = 1;
  EXPECT_NEAR(total(read(radiant_file(watts, 2, 555))), 683, 1e-3);
  expect_refused<UnsupportedError>(radiant_file({}, 2, 0), "right would be");
}

TEST(RayFile, Tm25Malformed) {
  const std::string good = tm25_bytes(two_rays);
  const auto with = [&](size_t at, uint32_t value) {
    std::string bytes = good;
    std::memcpy(&bytes[at], &value, 4);
    return bytes;
  };
  for (size_t size : {size_t(4), size_t(30), size_t(100), size_t(290), size_t(36287), good.size() - 1})
    expect_refused<ParseError>(good.substr(0, size), "byte ");
  expect_refused<ParseError>(good.substr(0, good.size() - 1), "the file ends before ray 2 of 2");
  expect_refused<ParseError>(with(20, 0), "byte 20: the number of rays is 0");
  expect_refused<ParseError>(with(24, 0xffffffff), "byte 20: the number of rays");
  expect_refused<ParseError>(with(256, 0), "byte 256: the flags of positions");
  expect_refused<ParseError>(with(272, 2), "byte 272: the flag of luminous flux is 2");
  expect_refused<ParseError>(with(272, 0), "neither luminous nor radiant");
  expect_refused<ParseError>(with(76, 0xffffffff), "byte 76: the number of spectral tables is -1");
  expect_refused<ParseError>(with(84, 0xffffffff), "byte 84:");
  expect_refused<ParseError>(with(76, 1), "spectral table 0");
  expect_refused<ParseError>(with(36288, 0x7fc00000), "byte 36288: ray 1 starts at a coordinate");
  expect_refused<ParseError>(with(36288 + 20, 0), "byte 36300: ray 1 has no direction");
  EXPECT_TRUE(warned(read(with(4, 2020)), "read as that of 2013"));
  EXPECT_TRUE(warned(read(good + "x"), "what follows the rays is ignored"));
  const Photometry dark = read(with(36288 + 24, 0xbf800000));
  EXPECT_EQ(dark.rays.size(), 1u);
  EXPECT_TRUE(warned(dark, "1 ray has a flux that is 0, negative or not finite; it is left out"));
}

std::string zemax(uint32_t unit, uint32_t format, uint32_t flux_type, double wavelength_um, uint32_t declared = 2) {
  ByteWriter w;
  w.u32(1010).u32(declared).text("A lamp").pad_to(108).f32({5, 5, wavelength_um}).pad_to(136).u32(unit).pad_to(192);
  w.u32(format).u32(flux_type).pad_to(208);
  for (int i = 0; i < 2; ++i) {
    w.f32({1.0 + i, 2, 3, 0, 0.6, -0.8, 4});
    if (format == 2) w.f32({0.555});
  }
  return w.bytes();
}

TEST(RayFile, Zemax) {
  const Photometry p = read(zemax(1, 0, 1, 0));
  ASSERT_EQ(p.rays.size(), 2u);
  expect_ray(p.rays[1], {2 * 0.0254, 2 * 0.0254, 3 * 0.0254}, {0, 0.6, -0.8}, 4);
  EXPECT_EQ(p.format, "Zemax binary rays");
  EXPECT_EQ(p.keywords.at(0).value, "A lamp");
  EXPECT_EQ(p.warnings.size(), 1u) << "that the table is a sample";
  const Photometry spectral = read(zemax(4, 2, 1, 0));
  expect_ray(spectral.rays[0], {0.001, 0.002, 0.003}, {0, 0.6, -0.8}, 4 * 683);
  EXPECT_TRUE(warned(spectral, "683 lm/W"));
  EXPECT_NEAR(total(read(zemax(0, 0, 0, 0.6))), 8 * 683 * 0.631, 1e-2);
  EXPECT_TRUE(read(zemax(0, 0, 0, 0.9)).rays.empty()) << "infrared";
  expect_refused<UnsupportedError>(zemax(0, 0, 0, 0), "no wavelength");
  expect_refused<ParseError>(zemax(5, 0, 1, 0), "byte 136: the unit of length is 5");
  expect_refused<ParseError>(zemax(0, 1, 1, 0), "byte 192: the ray format is 1");
  expect_refused<ParseError>(zemax(0, 0, 7, 0), "byte 196: the flux type is 7");
  expect_refused<ParseError>(zemax(0, 0, 1, 0, 3), "before ray 3 of 3");
  expect_refused<ParseError>(zemax(0, 0, 1, 0, 0), "byte 4: the number of rays is 0");
  expect_refused<ParseError>(zemax(0, 0, 1, 0, 0xffffffff), "before ray 3 of 4294967295");
  expect_refused<ParseError>(zemax(0, 0, 1, 0).substr(0, 120), "the file ends before");
}

std::string lighttools(uint32_t type, uint32_t colour, uint32_t unit, double total_flux,
                       const std::string& end = "LTRFEND") {
  ByteWriter w;
  w.text("LTRF").u32(2).u32(0).u32(type).u32(0).u32(colour).u32(unit).f32({0, 0, 0, total_flux});
  for (int i = 0; i < 2; ++i) {
    w.f32({1.0 + i, 2, 3, 0, 0.6, -0.8, 4});
    if (colour == 2) w.f32({555});
  }
  return w.text(end).bytes();
}

TEST(RayFile, LightTools) {
  const Photometry p = read(lighttools(1, 0, 2, 0));
  ASSERT_EQ(p.rays.size(), 2u);
  expect_ray(p.rays[1], {0.02, 0.02, 0.03}, {0, 0.6, -0.8}, 4);
  EXPECT_EQ(p.warnings.size(), 1u) << "that the table is a sample";
  EXPECT_NEAR(total(read(lighttools(1, 2, 3, 80))), 80, 1e-4);
  EXPECT_NEAR(total(read(lighttools(0, 2, 3, 1))), 683, 1e-3);
  EXPECT_TRUE(warned(read(lighttools(0, 2, 3, 1)), "add up to 8 W; they are scaled to the header's 1 W"));
  EXPECT_TRUE(warned(read(lighttools(1, 0, 0, 0)), "taken as millimetres"));
  EXPECT_TRUE(warned(read(lighttools(1, 0, 1, 0, "")), "LTRFEND is missing"));
  expect_refused<UnsupportedError>(lighttools(0, 0, 1, 0), "no wavelength");
  expect_refused<UnsupportedError>(lighttools(1, 1, 1, 0), "colour information 1");
  expect_refused<ParseError>(lighttools(2, 0, 1, 0), "byte 12: the data type is 2");
  expect_refused<ParseError>(lighttools(1, 0, 9, 0), "byte 24: the unit of length is 9");
  expect_refused<ParseError>(lighttools(1, 0, 1, 0, "LTRFEN"), "no whole number of them");
}

TEST(RayFile, ATiltChangesNothingAndSaysSo) {
  photometry::ReadOptions options;
  options.tilt_deg = 20;
  const Photometry p = photometry::test::read_text(tm25_bytes(two_rays), options);
  EXPECT_TRUE(warned(p, "there is no TILT table; the tilt of 20 degrees changes nothing"));
}

TEST(RayFile, UnknownSignature) {
  EXPECT_FALSE(photometry::is_ray_file("TM2", 3));
  EXPECT_FALSE(photometry::is_ray_file(nullptr, 0));
  EXPECT_THROW(photometry::read_ray_file("hello", 5), ParseError);
}

}  // namespace
}  // namespace ups::test
