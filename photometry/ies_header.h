// The lines of an IES file before its numbers: version, keywords, TILT=. Called by ies.cpp.
#pragma once
#include "photometry/ies_edition.h"
#include "photometry/text_reader.h"

namespace photometry {

struct IesHeader {
  IesEdition edition = IesEdition::y1986;
  std::vector<Keyword> keywords;
  std::string tilt;  // what follows TILT=
  size_t tilt_line = 0;
};

// Leaves `in` behind the TILT= line; without such a line, before the first line of at least ten numbers.
IesHeader read_ies_header(TextReader& in, std::vector<std::string>& warnings);

// The numbers of a TILT table, from after TILT=INCLUDE or from a TILT file.
Tilt read_tilt_table(TextReader& in, std::vector<std::string>& warnings);
// Interpolated linearly; beyond the table its ends.
double tilt_factor(const Tilt& tilt, double tilt_deg);

}  // namespace photometry
