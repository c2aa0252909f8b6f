// The luminous opening that the three dimensions of an IES file stand for; the codes differ by edition. Called by
// ies.cpp.
#pragma once
#include "photometry/ies_edition.h"

namespace photometry {

enum class OpeningMatch {
  edition,        // a code of the file's own edition
  other_edition,  // a code of another edition
  unknown         // no code of any edition: the bounding box is returned
};

// Signed dimensions as in the file, in metres: width along C90-C270, length along C0-C180, height vertical.
OpeningMatch ies_opening(IesEdition edition, double width, double length, double height, Opening& out);

}  // namespace photometry
