// The table and the integral of luminosity.h.
#include "photometry/luminosity.h"

#include <algorithm>
#include <cmath>

namespace photometry {
namespace {

constexpr double first_nm = 380, step_nm = 5, lumens_per_watt = 683;

// ISO/CIE 11664-1 and ISO/CIE 23539, V(lambda) from 380 to 780 nm by 5 nm.
constexpr double v[] = {0.000039,  0.000064,  0.00012,  0.000217,  0.000396, 0.00064,   0.00121, 0.00218,   0.0040,
                        0.0073,    0.0116,    0.01684,  0.0230,    0.0298,   0.0380,    0.0480,  0.0600,    0.0739,
                        0.09098,   0.1126,    0.13902,  0.1693,    0.20802,  0.2586,    0.3230,  0.4073,    0.5030,
                        0.6082,    0.7100,    0.7932,   0.8620,    0.91485,  0.9540,    0.9803,  0.99495,   1.0000,
                        0.9950,    0.9786,    0.9520,   0.9154,    0.8700,   0.8163,    0.7570,  0.6949,    0.6310,
                        0.5668,    0.5030,    0.4412,   0.3810,    0.3210,   0.2650,    0.2170,  0.1750,    0.1382,
                        0.1070,    0.0816,    0.0610,   0.04458,   0.0320,   0.0232,    0.0170,  0.01192,   0.00821,
                        0.005723,  0.004102,  0.002929, 0.002091,  0.001484, 0.001047,  0.00074, 0.00052,   0.000361,
                        0.0002492, 0.0001719, 0.00012,  0.0000848, 0.00006,  0.0000424, 0.00003, 0.0000212, 0.000015};
constexpr int count = int(sizeof v / sizeof *v);
static_assert(count == 81);

}  // namespace

double luminous_efficacy(double wavelength_nm) {
  const double at = (wavelength_nm - first_nm) / step_nm;
  if (!(at >= 0 && at <= count - 1)) return 0;
  const int i = std::min(int(at), count - 2);
  return lumens_per_watt * (v[i] + (v[i + 1] - v[i]) * (at - i));
}

double luminous_efficacy(const std::vector<std::pair<double, double>>& spectrum) {
  if (spectrum.size() == 1) return spectrum[0].second > 0 ? luminous_efficacy(spectrum[0].first) : 0;
  double lumens = 0, watts = 0;
  for (size_t i = 0; i + 1 < spectrum.size(); ++i) {
    const auto [a, power_a] = spectrum[i];
    const auto [b, power_b] = spectrum[i + 1];
    watts += 0.5 * (power_a + power_b) * (b - a);
    // Parts of at most a nanometre; V is 0 outside its table.
    const double from = std::clamp(a, first_nm, 780.0), to = std::clamp(b, first_nm, 780.0);
    const int parts = int(std::ceil(to - from));
    for (int k = 0; k < parts; ++k) {
      const double nm = from + (to - from) * (k + 0.5) / parts;
      lumens += (power_a + (power_b - power_a) * (nm - a) / (b - a)) * luminous_efficacy(nm) * (to - from) / parts;
    }
  }
  return watts > 0 ? lumens / watts : 0;
}

}  // namespace photometry
