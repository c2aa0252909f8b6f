// How many lumens is a watt? The luminosity function V of the CIE standard photometric observer (1924), for the readers
// of files that state radiant flux and wavelengths.
#pragma once
#include <utility>
#include <vector>

namespace photometry {

// lm/W at a wavelength: 683 V(lambda), 0 outside 380 to 780 nm. Linear between the table's steps of 5 nm.
double luminous_efficacy(double wavelength_nm);

// lm/W of a spectrum: (nm, power per nm) in ascending order, linear between its points, nothing beyond them; a single
// point is a line. 0 where the spectrum has no power.
double luminous_efficacy(const std::vector<std::pair<double, double>>& spectrum);

}  // namespace photometry
