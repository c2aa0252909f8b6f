// The editions of IES LM-63; factors, opening codes and angle ranges depend on them. Used by the parts of the IES
// reader.
#pragma once
#include "photometry/photometry.h"

namespace photometry {

enum class IesEdition { y1986, y1991, y1995, y2002, y2019 };

inline const char* name_of(IesEdition edition) {
  constexpr const char* names[] = {"IES LM-63-1986", "IES LM-63-1991", "IES LM-63-1995", "IES LM-63-2002",
                                   "IES LM-63-2019"};
  return names[int(edition)];
}

}  // namespace photometry
