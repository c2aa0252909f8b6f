// What must hold for whatever a reader accepts: finite fluxes, samples that agree with eval, and files written from it
// that read back to the same light. A failure ends the program, which libFuzzer reports with its input. Used by the
// fuzz targets of readers of distributions.
#pragma once
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "photometry/photometry.h"

namespace photometry::fuzz {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

// part: of the peak, what a format's digits round.
inline void require_same(const Distribution& a, const Distribution& b, double part) {
  require(a.type() == b.type(), "the type is kept");
  require(a.gamma_deg() == b.gamma_deg(), "the rows are kept");
  // A table whose planes are all alike is written as one plane.
  const bool merged = a.c_deg().size() > 1 && b.c_deg().size() == 1;
  require(merged || a.c_deg().size() == b.c_deg().size(), "the planes are kept");
  for (size_t i = 0; i < a.c_deg().size(); ++i) {
    require(b.c_deg().size() == 1 || std::abs(a.c_deg()[i] - b.c_deg()[i]) < 1e-9, "the angles are kept");
    for (size_t j = 0; j < a.gamma_deg().size(); ++j)
      require(std::abs(a.at(i, j) - b.at(merged ? 0 : i, j)) <= part * a.peak_cd() + 1e-300, "intensities are kept");
  }
}

inline Photometry read_again(const std::string& text) { return read(text.data(), text.size()); }

inline void check(const Photometry& p) {
  const Distribution& d = p.distribution;
  require(std::isfinite(d.band_flux_lm()) && d.band_flux_lm() >= 0, "the band flux is finite");
  require(std::isfinite(d.interpolated_flux_lm()) && d.interpolated_flux_lm() >= 0, "the flux is finite");
  const Distribution::Sample s = d.sample(0.3, 0.6);
  require(std::isfinite(s.x + s.y + s.z + s.intensity_cd), "a sample is finite");
  require(d.eval(s.x, s.y, s.z) <= d.peak_cd() * (1 + 1e-9), "no intensity above the peak");

  const Photometry ies = read_again(write_ies(p));
  require(ies.format == "IES LM-63-2019", "the written IES file is recognised");
  require_same(d, ies.distribution, 1e-12);
  // EULUMDAT has C-planes alone, angles and intensities of six characters: written once more, they stay. Of other
  // tables a coarse grid, as the writer's own takes milliseconds.
  Photometry planes = p;
  if (d.type() != PhotometricType::c)
    planes.distribution = d.resampled({0, 45, 90, 135, 180, 225, 270, 315}, {0, 22.5, 45, 67.5, 90, 135, 180});
  if (planes.distribution.gamma_deg().back() - planes.distribution.gamma_deg().front() < 1) return;  // too close to tell
  const Photometry ldt = read_again(write_eulumdat(planes));
  require(ldt.format == "EULUMDAT", "the written EULUMDAT file is recognised");
  require_same(ldt.distribution, read_again(write_eulumdat(ldt)).distribution, 1e-4);
}

// Runs a reader as a fuzz target: refusals are part of its job.
template <class Read>
int one_input(const Read& read_it) {
  try {
    check(read_it());
  } catch (const ParseError&) {
  } catch (const UnsupportedError&) {
  }
  return 0;
}

}  // namespace photometry::fuzz
