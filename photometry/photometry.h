// A photometric file as read or to be written: a distribution, the luminous opening, what the file says of the luminaire,
// or the rays of a ray file. Made by the readers (ies, eulumdat, tm33, ray files) and by programs; the standard library
// only.
#pragma once
#include "photometry/distribution.h"

namespace photometry {

class ParseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
class UnsupportedError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Symmetry { none, axial, c0_c180, c90_c270, quadrants };
enum class OpeningShape { point, rectangle, disc, box, cylinder, sphere };

// The luminous opening, centred on the photometric centre. A rectangle and a disc lie in the plane of the axis along which
// they have no extent; a disc, a cylinder and a sphere of unequal sizes are elliptical. All sides of a box shine.
struct Opening {
  OpeningShape shape = OpeningShape::point;
  float size_m[3] = {0, 0, 0};  // along local x (C0-C180), y (C90-C270), z
  int axis = 2;                 // of a cylinder: 0 x, 1 y, 2 z
};

struct Keyword {
  std::string name, value;
};

// Factors on all intensities by the tilt of a luminaire with HID lamps. Applied only where ReadOptions ask for it.
struct Tilt {
  int lamp_geometry = 0;  // 1 vertical, 2 horizontal and stays so, 3 horizontal and tilts along; 0: no table
  std::vector<double> angle_deg, factor;
};

// A set of lamps that a luminaire can bear; several in a file are alternatives.
struct LampSet {
  int count = 0;
  std::string type;
  double flux_lm = -1;  // of all its lamps; < 0: not stated
  std::string colour, colour_rendering;
  double power_w = -1;  // with gear; < 0: not stated
};

// Of a ray file, in the luminaire's frame.
struct Ray {
  float p_m[3], direction[3];  // direction: unit
  float flux_lm;
};

// How the file itself tabulates directions (LM-63); Distribution answers in C-gamma terms for all of them.
enum class PhotometricType { c, b, a };

struct Photometry {
  Distribution distribution;
  Opening opening;
  Symmetry symmetry = Symmetry::none;
  double rated_flux_lm = -1;  // of the lamps; < 0: absolute photometry
  double input_power_w = -1;
  std::string format;             // "IES LM-63-2002"
  std::vector<Keyword> keywords;  // in the file's order; free label lines under the name LABEL
  Tilt tilt;
  std::vector<std::string> warnings;  // each with its line
  PhotometricType type = PhotometricType::c;
  std::vector<LampSet> lamp_sets;  // of an EULUMDAT file; the emitters of a TM-33 file
  std::vector<Ray> rays;           // of a ray file; the distribution is then their far field, binned
};

struct ReadOptions {
  const void* tilt_file = nullptr;  // bytes of the file that TILT= names; null: taken as TILT=NONE, with a warning
  size_t tilt_file_size = 0;
  double tilt_deg = -1;  // >= 0: multiplies the intensities by the TILT factor at this tilt of the luminaire
  size_t lamp_set = 0;   // of an EULUMDAT file, from 0
};

// bytes: an IES LM-63 file of any edition. Throws ParseError ("line 12: ...") or UnsupportedError.
Photometry read_ies(const void* bytes, size_t size);
// bytes: a ray file: IES TM-25 (.tm25ray), Zemax binary (.sdf, .dat) or LightTools binary (LTRF), known by its first
// bytes. The file's axes are taken as they are: its x, y, z are the luminaire's local x, y, z, whose nadir is -z. The
// fluxes are scaled to the header's total where it states one; radiant flux becomes luminous by wavelength or spectrum.
// What is read otherwise than it is written has a warning. Throws ParseError ("byte 20: ...") or UnsupportedError.
Photometry read_ray_file(const void* bytes, size_t size);
bool is_ray_file(const void* bytes, size_t size);
// Recognises the format.
Photometry read(const void* bytes, size_t size);

}  // namespace photometry
