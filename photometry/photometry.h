// A photometric file as read or to be written: a distribution, the luminous opening, what the file says of the
// luminaire, or the rays of a ray file. Made by the readers (ies, eulumdat, tm33, ray files) and by programs; the
// standard library only.
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

// The luminous opening, centred on the photometric centre. A rectangle and a disc lie in the plane of the axis along
// which they have no extent; a disc, a cylinder and a sphere of unequal sizes are elliptical. All sides of a box shine.
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
  PhotometricType type = PhotometricType::c;  // of the file; Distribution answers in C-gamma terms for all of them
  // Of an EULUMDAT file all, alternatives; of an IES file its lamps;
  // of a TM-33 file its emitters, which shine together.
  std::vector<LampSet> lamp_sets;
  std::vector<Ray> rays;           // of a ray file; the distribution is then their far field, binned
  size_t lamp_set = 0;             // the set that the intensities hold for
  bool lamps_shine_together = false;  // the intensities hold for all sets
  std::string tilt_file_name;      // that TILT= names; empty: none
  double file_generation = -1;     // "file generation type" of LM-63-2019, such as 1.0001 (simulation); < 0: not stated
};

struct ReadOptions {
  const void* tilt_file = nullptr;  // bytes of the file that TILT= names; null: taken as TILT=NONE, with a warning
  size_t tilt_file_size = 0;
  double tilt_deg = -1;  // >= 0: multiplies the intensities by the TILT factor at this tilt of the luminaire
  size_t lamp_set = 0;   // of an EULUMDAT file, from 0
};

// bytes: an IES LM-63 file of any edition, an EULUMDAT file. Throw ParseError ("line 12: ..."), UnsupportedError, or
// std::invalid_argument where the options ask for what the file does not have.
Photometry read_ies(const void* bytes, size_t size, const ReadOptions& options = {});
Photometry read_eulumdat(const void* bytes, size_t size, const ReadOptions& options = {});
// bytes: an XML file of ANSI/IES TM-33 (of 2018, which is ATLA S001 and UNI 11733, or of 2023). Luminous intensity is
// read; several emitters are added up, with a warning: ReadOptions::lamp_set does not choose among them. Relative
// intensities are in cd per 1000 lm of the emitter's RatedLumens. Throws as the others do.
Photometry read_tm33(const void* bytes, size_t size, const ReadOptions& options = {});
// bytes: a ray file: IES TM-25 (.tm25ray), Zemax binary (.sdf, .dat) or LightTools binary (LTRF), known by its first
// bytes. The file's axes are taken as they are: its x, y, z are the luminaire's local x, y, z, whose nadir is -z. The
// fluxes are scaled to the header's total where it states one; radiant flux becomes luminous by wavelength or spectrum.
// What is read otherwise than it is written has a warning. Throws ParseError ("byte 20: ...") or UnsupportedError.
Photometry read_ray_file(const void* bytes, size_t size, const ReadOptions& options = {});
bool is_ray_file(const void* bytes, size_t size);
// Recognises the format.
Photometry read(const void* bytes, size_t size, const ReadOptions& options = {});

// The bytes of a file of the same distribution. A symmetric table is written by the planes that the format asks for.
// warnings: optional; added to what the file does not hold as the photometry has it, by reading it back: flux and peak
// where they part by more than 0.1 %. Throw std::invalid_argument for what the format cannot hold.
// LM-63-2019: reads back to the same bits; type A and B tables as they are; lamps, opening, keywords, TILT table;
// absolute where no rated flux is known. File generation type: photometry.file_generation, or 1.00001 (undefined).
std::string write_ies(const Photometry& photometry, std::vector<std::string>* warnings = nullptr);
// EULUMDAT: type A and B tables resampled (c_gamma.h), the chosen or first lamp set alone, no tilt table; of the
// keywords those that have a line. Fields in the lengths of the format, angles and intensities in six characters: of
// what is cut or does not fit there is a warning.
std::string write_eulumdat(const Photometry& photometry, std::vector<std::string>* warnings = nullptr);

}  // namespace photometry
