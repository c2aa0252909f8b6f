// Reads IES TM-25 ray files (.tm25ray). Called by ray_file.cpp.
//
// Layout, little-endian: header of 288 bytes, nine texts of 1000 UTF-32 characters, spectral tables, names of
// additional columns, a free text, then the rays as rows of floats whose columns the header's flags choose.
// Millimetres, nanometres.
#include <cmath>

#include "photometry/luminosity.h"
#include "photometry/ray_table.h"
#include "photometry/text_reader.h"

namespace photometry {
namespace {

constexpr size_t flags_at = 256, texts_at = 288, text_size = 4000, tables_at = 36288, name_size = 512;
constexpr uint32_t most_of_a_kind = 1000;  // spectral tables, additional columns

using Spectrum = std::vector<std::pair<double, double>>;

class Tm25Reader {
 public:
  explicit Tm25Reader(const FileBytes& file) : f_(file) {}
  Photometry read();

 private:
  uint32_t count(size_t at, const char* field, uint32_t most) const;
  bool flag(size_t index, const char* name) const;
  void read_texts(Photometry& out) const;
  void read_spectra(uint32_t tables);
  Spectrum read_spectrum(uint32_t index);
  void choose_columns();
  void choose_flux(Photometry& out);
  void check_end(Photometry& out) const;

  const FileBytes& f_;
  RayTable table_;
  size_t at_ = tables_at;
  std::vector<double> efficacy_;
  size_t radiant_ = 0, wavelength_ = 0, luminous_ = 0, spectrum_ = 0;  // columns; 0: not there
};

uint32_t Tm25Reader::count(size_t at, const char* field, uint32_t most) const {
  const uint32_t n = f_.u32(at, field);
  if (n > most)
    fail_at_byte(at, std::string(field) + " is " + std::to_string(int32_t(n)) + "; it must be from 0 to " +
                         std::to_string(most));
  return n;
}

bool Tm25Reader::flag(size_t index, const char* name) const {
  const size_t at = flags_at + 4 * index;
  const uint32_t value = f_.u32(at, name);
  if (value > 1)
    fail_at_byte(at, std::string(name) + " is " + std::to_string(int32_t(value)) + "; it must be 0 (not there) or 1");
  return value == 1;
}

void Tm25Reader::read_texts(Photometry& out) const {
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) out.keywords.push_back({name, value});
  };
  add("TESTDATE", f_.latin1(28, 28, "the date"));
  static constexpr const char* names[] = {"LUMINAIRE", "MANUFAC", "_MODELCREATOR", "_RAYFILECREATOR", "_EQUIPMENT",
                                          "_CAMERA",   "LAMP",    "OTHER",         "_DATAREFERENCE"};
  for (size_t i = 0; i < 9; ++i) add(names[i], f_.utf32(texts_at + text_size * i, text_size, "the header's texts"));
}

// Pairs of wavelength and weight.
Spectrum Tm25Reader::read_spectrum(uint32_t index) {
  const std::string name = "spectral table " + std::to_string(index);
  const size_t start = at_;
  const uint32_t n = f_.u32(at_, "a spectral table");
  at_ += 4;
  if (n == 0 || n > (f_.size() - at_) / 8)
    fail_at_byte(start,
                 name + " has " + std::to_string(int32_t(n)) + " pairs; it must have at least 1 and fit into the file");
  Spectrum spectrum;
  for (uint32_t i = 0; i < n; ++i, at_ += 8) {
    const double nm = f_.f32(at_, "a wavelength"), power = f_.f32(at_ + 4, "a weight");
    if (!(nm > 0 && nm < 1e6) || (i > 0 && !(nm > spectrum.back().first)))
      fail_at_byte(at_, name + ": the wavelength " + shown(nm) + " nm is not above the one before");
    if (!(power >= 0 && power <= 1e30))
      fail_at_byte(at_ + 4, name + ": the weight " + shown(power) + " is not 0 or more");
    spectrum.emplace_back(nm, power);
  }
  return spectrum;
}

// The block is padded to a multiple of 32 bytes.
void Tm25Reader::read_spectra(uint32_t tables) {
  for (uint32_t i = 0; i < tables; ++i) efficacy_.push_back(luminous_efficacy(read_spectrum(i)));
  at_ = tables_at + (at_ - tables_at + 31) / 32 * 32;
}

void Tm25Reader::choose_columns() {
  if (!flag(0, "the flag of positions") || !flag(1, "the flag of directions"))
    fail_at_byte(flags_at, "the flags of positions and directions must be 1: every ray has both");
  size_t column = 6;
  const auto take = [&](size_t index, const char* name, size_t width) -> size_t {
    if (!flag(index, name)) return 0;
    column += width;
    return column - width;
  };
  radiant_ = take(2, "the flag of radiant flux", 1);
  wavelength_ = take(3, "the flag of wavelengths", 1);
  luminous_ = take(4, "the flag of luminous flux", 1);
  take(5, "the flag of Stokes vectors", 6);
  take(6, "the flag of tristimulus values", 2);  // Y is the luminous flux
  spectrum_ = take(7, "the flag of spectrum indices", 1);
  table_.columns = column;
}

// Lumens as the file states them, or else from watts by wavelength or spectrum.
void Tm25Reader::choose_flux(Photometry& out) {
  table_.total_lm = f_.f32(12, "the luminous flux");
  const double radiant_total = f_.f32(16, "the radiant flux"), wavelength_nm = f_.f32(64, "the wavelength");
  const uint32_t spectral = count(60, "the spectral data identifier", 4);
  if (luminous_) {
    table_.flux = luminous_;
    return;
  }
  if (!radiant_)
    fail_at_byte(flags_at + 8, "the rays have neither luminous nor radiant flux; one of both flags must be 1");
  table_.flux = radiant_, table_.unit = "W", table_.total_units = radiant_total;
  const char* by = "by their wavelengths";
  if (wavelength_) {
    table_.wavelength = wavelength_;
  } else if (spectrum_ && !efficacy_.empty()) {
    table_.spectrum = spectrum_, table_.efficacy = efficacy_, by = "by their spectra";
  } else if (spectral == 3 && efficacy_.size() == 1) {
    table_.lumens_per_unit = efficacy_[0], by = "by their spectrum";
  } else if (spectral == 1 && wavelength_nm > 0 && wavelength_nm < 1e6) {
    table_.lumens_per_unit = luminous_efficacy(wavelength_nm);
  } else if (std::isfinite(table_.total_lm) && table_.total_lm > 0) {
    out.warnings.push_back(
        "the rays' flux is radiant without a spectrum; all rays are taken to have the same one, and "
        "add up to the header's luminous flux");
    return;
  } else {
    throw UnsupportedError(at_byte(flags_at + 8,
                                   "the rays' flux is radiant and has no wavelength or spectrum: it cannot "
                                   "become lumens; right would be the luminous flux of each ray, a "
                                   "wavelength or spectrum, or the header's luminous flux"));
  }
  out.warnings.push_back(std::string("the rays' flux is radiant; it is converted ") + by +
                         ": 683 lm/W V(lambda), CIE 1924");
}

void Tm25Reader::check_end(Photometry& out) const {
  const size_t end = table_.begin + table_.count * 4 * table_.columns;
  if (f_.size() > end) out.warnings.push_back(at_byte(end, "what follows the rays is ignored"));
}

Photometry Tm25Reader::read() {
  Photometry out = dark_photometry();
  const uint32_t version = f_.u32(4, "the version");
  out.format = "IES TM-25";
  if (version != 2013)
    out.warnings.push_back(at_byte(4, "the version is " + std::to_string(int32_t(version)) + "; read as that of 2013"));
  const uint64_t rays = f_.u64(20, "the number of rays");
  const uint32_t tables = count(76, "the number of spectral tables", most_of_a_kind),
                 additional = count(80, "the number of additional columns", most_of_a_kind),
                 text = f_.u32(84, "the size of the additional text");
  if (text > f_.size())
    fail_at_byte(84, "the size of the additional text is " + std::to_string(text) + " bytes, more than the file has");
  choose_columns();
  read_texts(out);
  if (rays == 0 || rays > f_.size())
    fail_at_byte(20, "the number of rays is " + std::to_string(rays) +
                         "; it must be at least 1 and fit into the file's " + std::to_string(f_.size()) + " bytes");
  read_spectra(tables);
  choose_flux(out);
  table_.columns += additional;
  table_.begin = at_ + name_size * additional + text;
  table_.count = size_t(rays);
  table_.metres = 0.001;
  read_rays(f_, table_, out);
  check_end(out);
  return out;
}

}  // namespace

Photometry read_tm25(const FileBytes& file) { return Tm25Reader(file).read(); }

}  // namespace photometry
