// Recognises ray files, and reads those whose header is short: Zemax binary (.sdf, .dat) and LightTools binary (LTRF).
// Called by programs and by read(). A file's axes are taken as the luminaire's: x, y, z of a ray are local x, y, z, so
// that its light must leave towards -z to shine down.
//
// Layouts: OpticStudio help, "Source File" (its numbers of rays, units, format and flux type count, nothing else of the
// header); LightTools ray data files as TM25RaySetTools reads and writes them.
#include "photometry/luminosity.h"
#include "photometry/ray_table.h"
#include "photometry/text_reader.h"

namespace photometry {
namespace {

constexpr uint32_t zemax_id = 1010;
constexpr char lighttools_end[] = "LTRFEND";

bool is_zemax(const FileBytes& f) { return f.size() >= 4 && f.u32(0, "the identifier") == zemax_id; }

void warn_of_conversion(Photometry& out) {
  out.warnings.push_back(
      "the rays' flux is radiant; it is converted by their wavelengths: 683 lm/W V(lambda), CIE 1924");
}

Photometry read_zemax(const FileBytes& f) {
  static constexpr double metres[] = {1, 0.0254, 0.01, 0.3048, 0.001};
  Photometry out = dark_photometry();
  out.format = "Zemax binary rays";
  RayTable table;
  table.begin = 208;
  table.count = f.u32(4, "the number of rays");
  const std::string text = f.latin1(8, 100, "the description");
  if (!text.empty()) out.keywords.push_back({"LABEL", text});
  const double wavelength_um = f.f32(116, "the wavelength");
  const uint32_t unit = f.u32(136, "the unit of length"), format = f.u32(192, "the ray format"),
                 flux_type = f.u32(196, "the flux type");
  if (table.count == 0) fail_at_byte(4, "the number of rays is 0; there must be at least 1");
  if (unit > 4)
    fail_at_byte(136, "the unit of length is " + std::to_string(unit) +
                          "; it must be 0 (m), 1 (in), 2 (cm), 3 (ft) "
                          "or 4 (mm)");
  table.metres = metres[unit];
  if (format == 2) {
    table.columns = 8, table.wavelength = 7, table.nanometres = 1000;
  } else if (format != 0) {
    fail_at_byte(192, "the ray format is " + std::to_string(format) + "; it must be 0 (flux) or 2 (spectral)");
  } else if (flux_type == 0) {
    if (!(wavelength_um > 0 && wavelength_um < 1e3))
      throw UnsupportedError(at_byte(116,
                                     "the rays' flux is radiant and has no wavelength: it cannot become lumens; "
                                     "right would be flux type 1 (lm), ray format 2 (a wavelength each), or one "
                                     "wavelength in the header"));
    table.lumens_per_unit = luminous_efficacy(1000 * wavelength_um);
  } else if (flux_type != 1) {
    fail_at_byte(196, "the flux type is " + std::to_string(flux_type) + "; it must be 0 (W) or 1 (lm)");
  }
  if (format == 2 || flux_type == 0) warn_of_conversion(out);
  read_rays(f, table, out);
  if (f.size() > table.begin + table.count * 4 * table.columns)
    out.warnings.push_back(at_byte(table.begin + table.count * 4 * table.columns, "what follows the rays is ignored"));
  return out;
}

// The unit of length; 0 is the system's, which the file does not tell.
double lighttools_metres(uint32_t unit, Photometry& out) {
  static constexpr double metres[] = {0.001, 0.001, 0.01, 1, 0.0254, 0.3048, 1e-6, 1e-9};
  if (unit > 7)
    fail_at_byte(24, "the unit of length is " + std::to_string(unit) +
                         "; it must be 0 (system), 1 (mm), 2 (cm), "
                         "3 (m), 4 (in), 5 (ft), 6 (um) or 7 (nm)");
  if (unit == 0) out.warnings.push_back(at_byte(24, "the unit of length is that of a system; taken as millimetres"));
  return metres[unit];
}

// Rays up to the end mark, which closes the file.
void count_lighttools_rays(const FileBytes& f, RayTable& table, Photometry& out) {
  constexpr size_t mark = sizeof lighttools_end - 1;
  const bool closed = f.size() >= table.begin + mark && f.starts_with(lighttools_end, f.size() - mark);
  const size_t end = closed ? f.size() - mark : f.size(), bytes = 4 * table.columns;
  if (end < table.begin || (end - table.begin) % bytes != 0)
    fail_at_byte(table.begin, "the rays have " + std::to_string(bytes) + " bytes each; " +
                                  std::to_string(end > table.begin ? end - table.begin : 0) +
                                  " bytes are there, no whole number of them: the file is cut short, or its columns "
                                  "are not known here");
  table.count = (end - table.begin) / bytes;
  if (table.count == 0) fail_at_byte(table.begin, "the file has no ray");
  if (!closed) out.warnings.push_back(at_byte(f.size(), "the mark LTRFEND is missing: the file may be cut short"));
}

Photometry read_lighttools(const FileBytes& f) {
  Photometry out = dark_photometry();
  out.format = "LightTools binary rays";
  const uint32_t major = f.u32(4, "the version"), photometric = f.u32(12, "the data type"),
                 far_field = f.u32(16, "the far-field flag"), colour = f.u32(20, "the colour information");
  RayTable table;
  table.begin = 44;
  if (major != 2 && major != 3)
    throw UnsupportedError(
        at_byte(4, "LightTools ray files of version " + std::to_string(major) + " are not read; those of 2 and 3 are"));
  if (major == 3) {
    if (f.u32(44, "the polarisation flag") != 0)
      throw UnsupportedError(at_byte(44, "polarised rays are not read; write the file without polarisation"));
    table.begin = 48;
  }
  if (photometric > 1)
    fail_at_byte(12, "the data type is " + std::to_string(photometric) +
                         "; it must be 0 (radiometric) or 1 "
                         "(photometric)");
  if (far_field != 0)
    throw UnsupportedError(at_byte(16, "far-field rays (directions alone) are not read; write them with positions"));
  if (colour == 1 || colour > 2)
    throw UnsupportedError(at_byte(20, "colour information " + std::to_string(colour) +
                                           " is not read; none (0) or a "
                                           "wavelength (2) is"));
  table.metres = lighttools_metres(f.u32(24, "the unit of length"), out);
  for (size_t k = 0; k < 3; ++k)
    if (f.f32(28 + 4 * k, "the origin") != 0) {
      out.warnings.push_back(at_byte(28, "the origin is not 0; it is not added to the rays' positions"));
      break;
    }
  table.total_units = f.f32(40, "the total flux");
  if (colour == 2) table.columns = 8;
  if (photometric == 0) {
    table.unit = "W";
    if (colour == 0)
      throw UnsupportedError(at_byte(12,
                                     "the rays' flux is radiant and has no wavelength: it cannot become lumens; "
                                     "right would be photometric data, or a wavelength each"));
    table.wavelength = 7;
    warn_of_conversion(out);
  }
  count_lighttools_rays(f, table, out);
  read_rays(f, table, out);
  return out;
}

}  // namespace

bool is_ray_file(const void* bytes, size_t size) {
  const FileBytes f(bytes, size);
  if (is_zemax(f)) return true;
  // Numbers follow, of which a small one has a byte that no text has: a maker's name may begin so, too.
  const std::string_view first(static_cast<const char*>(bytes), std::min<size_t>(size, 12));
  return (f.starts_with("TM25") || f.starts_with("LTRF")) && (size < 12 || first.find('\0') != first.npos);
}

Photometry read_ray_file(const void* bytes, size_t size, const ReadOptions& options) {
  if (options.lamp_set != 0)
    throw std::invalid_argument("lamp_set is " + std::to_string(options.lamp_set) + "; a ray file has one, 0");
  const FileBytes f(bytes, size);
  if (!is_ray_file(bytes, size))
    fail_at_byte(0,
                 "not a ray file: it must start with TM25 (IES TM-25), LTRF (LightTools) or the number 1010 (Zemax)");
  Photometry out = f.starts_with("TM25") ? read_tm25(f) : f.starts_with("LTRF") ? read_lighttools(f) : read_zemax(f);
  if (options.tilt_deg >= 0) out.warnings.push_back(no_tilt_table(options.tilt_deg));
  return out;
}

}  // namespace photometry
