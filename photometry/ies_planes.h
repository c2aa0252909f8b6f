// What the range of an IES file's angles means: which part of the table it states, and the table of it. Called by
// ies.cpp.
#pragma once
#include "photometry/ies_edition.h"
#include "photometry/planes.h"

namespace photometry {

// The table as in the file, both angles ascending: the intensities at each vertical angle, for each horizontal angle.
struct IesTable {
  PhotometricType type;
  std::vector<double> vertical_deg;
  std::vector<Plane> planes;  // c_deg: the horizontal angle
};

struct AngleLines {
  size_t vertical, horizontal;  // where the angles end, for messages
};

// Completes what a symmetry left out. Throws ParseError with their line for ranges that the type does not
// have.
Distribution arrange_ies_table(IesTable table, IesEdition edition, const AngleLines& lines, Symmetry& symmetry,
                               std::vector<std::string>& warnings);

}  // namespace photometry
