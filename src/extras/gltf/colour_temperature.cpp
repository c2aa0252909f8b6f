// The colour of a black body: `colour_temperature_k` of luminaires and emitters.
#include <cmath>

#include "gltf/import.h"

namespace ups::gltf {

namespace {

constexpr double min_temperature = 800, max_temperature = 1e6;
constexpr double min_of_fit = 1667, max_of_fit = 25000;

struct Chromaticity {
  double x, y;
};

// Kang et al. 2002, "Design of advanced color temperature control system for HDTV applications", J. Korean Phys. Soc. 41
// (6): from 1667 K to 25000 K.
Chromaticity by_fit(double kelvin) {
  const double t = 1e3 / kelvin;
  const double x = kelvin <= 4000 ? -0.2661239 * t * t * t - 0.2343589 * t * t + 0.8776956 * t + 0.179910
                                  : -3.0258469 * t * t * t + 2.1070379 * t * t + 0.2226347 * t + 0.240390;
  if (kelvin <= 2222) return {x, -1.1063814 * x * x * x - 1.34811020 * x * x + 2.18555832 * x - 0.20219683};
  if (kelvin <= 4000) return {x, -0.9549476 * x * x * x - 1.37418593 * x * x + 2.09137015 * x - 0.16748867};
  return {x, 3.0817580 * x * x * x - 5.87338670 * x * x + 3.75112997 * x - 0.37001483};
}

// The colour matching functions of the CIE 1931 observer, from 380 nm in steps of 10 nm, to four decimals.
constexpr double observer[][3] = {
    {0.0014, 0, 0.0065},           {0.0042, 0.0001, 0.0201}, {0.0143, 0.0004, 0.0679}, {0.0435, 0.0012, 0.2074},
    {0.1344, 0.0040, 0.6456},      {0.2839, 0.0116, 1.3856}, {0.3483, 0.0230, 1.7471}, {0.3362, 0.0380, 1.7721},
    {0.2908, 0.0600, 1.6692},      {0.1954, 0.0910, 1.2876}, {0.0956, 0.1390, 0.8130}, {0.0320, 0.2080, 0.4652},
    {0.0049, 0.3230, 0.2720},      {0.0093, 0.5030, 0.1582}, {0.0633, 0.7100, 0.0782}, {0.1655, 0.8620, 0.0422},
    {0.2904, 0.9540, 0.0203},      {0.4334, 0.9950, 0.0087}, {0.5945, 0.9950, 0.0039}, {0.7621, 0.9520, 0.0021},
    {0.9163, 0.8700, 0.0017},      {1.0263, 0.7570, 0.0011}, {1.0622, 0.6310, 0.0008}, {1.0026, 0.5030, 0.0003},
    {0.8544, 0.3810, 0.0002},      {0.6424, 0.2650, 0},      {0.4479, 0.1750, 0},      {0.2835, 0.1070, 0},
    {0.1649, 0.0610, 0},           {0.0874, 0.0320, 0},      {0.0468, 0.0170, 0},      {0.0227, 0.0082, 0},
    {0.0114, 0.0041, 0},           {0.0058, 0.0021, 0},      {0.0029, 0.0010, 0},      {0.0014, 0.0005, 0},
    {0.0007, 0.0003, 0},           {0.0003, 0.0001, 0},      {0.0002, 0.0001, 0},      {0.0001, 0, 0}};

// Planck's law, weighed with them.
Chromaticity by_law(double kelvin) {
  constexpr double second_radiation_constant = 0.014387769;  // m K (CODATA 2018)
  double sums[3] = {}, metres = 380e-9;
  for (const auto& weights : observer) {
    const double radiance = std::pow(metres * 1e7, -5) / std::expm1(second_radiation_constant / (metres * kelvin));
    for (int k = 0; k < 3; ++k) sums[k] += weights[k] * radiance;
    metres += 10e-9;
  }
  const double all = sums[0] + sums[1] + sums[2];
  return {sums[0] / all, sums[1] / all};
}

// Linear Rec.709 (IEC 61966-2-1 matrix), negative components clipped, then scaled to luminance 1.
Rgb planckian_rgb(double kelvin) {
  const auto [x, y] = kelvin < min_of_fit || kelvin > max_of_fit ? by_law(kelvin) : by_fit(kelvin);
  const double X = x / y, Z = (1 - x - y) / y;  // Y = 1
  Rgb rgb = {3.2404542 * X - 1.5371385 - 0.4985314 * Z, -0.9692660 * X + 1.8760108 + 0.0415560 * Z,
             0.0556434 * X - 0.2040259 + 1.0572252 * Z};
  for (double& c : rgb) c = std::max(c, 0.0);
  const double scale = luminance(rgb);
  for (double& c : rgb) c /= scale;
  return rgb;
}

}  // namespace

void read_colour_temperature(const JsonReader& reader, float (&rgb)[3]) {
  if (!reader.has("colour_temperature_k")) return;
  store(planckian_rgb(reader.number("colour_temperature_k", 0, min_temperature, max_temperature)), rgb);
}

}  // namespace ups::gltf
