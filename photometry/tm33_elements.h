// What TM-33 files of both editions say of light, element by element, before it is made a distribution. Used by
// tm33.cpp.
#pragma once
#include "photometry/tm33_table.h"

namespace photometry {

struct Tm33Intensity {
  size_t line = 0;  // 0: the emitter has none
  enum { unstated, absolute, relative } photometry = unstated;
  std::string symmetry;  // upper case, without blanks and underscores; "": not stated
  double multiplier = 1, measured = -1, horizontal = -1, vertical = -1;
  std::vector<DirectedValue> values;
};

struct Tm33Emitter {
  size_t line = 0;
  LampSet lamp;
  double ballast_factor = 1;
  Tm33Intensity intensity;
  std::string other_data;  // the last of those that are not read
};

struct Tm33Area {  // that emits
  size_t line = 0;
  int face = 2;  // the axis that it is normal to
  double size_m[3] = {0, 0, 0}, offset_m[3] = {0, 0, 0};  // of its middle
  bool round = false;
};

struct Tm33File {
  std::string format;
  PhotometricType type = PhotometricType::c;
  std::vector<Keyword> keywords;
  std::vector<std::string> warnings;
  std::vector<Tm33Emitter> emitters;  // one at least
  std::vector<Tm33Area> areas;
};

// Throws ParseError, and UnsupportedError where the file is none of TM-33 or not of luminous intensity.
Tm33File read_tm33_elements(std::string text);

}  // namespace photometry
