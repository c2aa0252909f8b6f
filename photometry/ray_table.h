// What the readers of ray files share: numbers at places of a file, and the rays of a table with their lumens. Used by
// ray_file.cpp and tm25.cpp alone.
#pragma once
#include <cstring>
#include <limits>

#include "photometry/photometry.h"

namespace photometry {

inline std::string at_byte(size_t offset, const std::string& what) {
  return "byte " + std::to_string(offset) + ": " + what;
}
[[noreturn]] inline void fail_at_byte(size_t offset, const std::string& what) {
  throw ParseError(at_byte(offset, what));
}

// Little-endian numbers of a file's bytes, which outlive it.
class FileBytes {
 public:
  FileBytes(const void* bytes, size_t size) : data_(static_cast<const unsigned char*>(bytes)), size_(size) {}
  size_t size() const { return size_; }
  bool starts_with(const char* signature, size_t at = 0) const {
    const size_t n = std::strlen(signature);
    return size_ >= n && at <= size_ - n && std::memcmp(data_ + at, signature, n) == 0;
  }
  // Throws ParseError where the file ends before the field.
  uint32_t u32(size_t at, const char* field) const { return uint32_t(number(at, 4, field)); }
  uint64_t u64(size_t at, const char* field) const { return number(at, 8, field); }
  float f32(size_t at, const char* field) const {
    uint32_t bits = u32(at, field);
    if ((bits & 0x7fffffff) > 0x7f800000) bits |= 0x00400000;  // what is no number may be read without a signal
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  // Up to the first zero, in `size` bytes that must be there: Latin-1, or UTF-32, as UTF-8 without controls.
  std::string latin1(size_t at, size_t size, const char* field) const;
  std::string utf32(size_t at, size_t size, const char* field) const;

 private:
  uint64_t number(size_t at, size_t n, const char* field) const {
    require(at, n, field);
    uint64_t value = 0;
    for (size_t i = n; i-- > 0;) value = value << 8 | data_[at + i];
    return value;
  }
  void require(size_t at, size_t n, const char* field) const {
    if (size_ < n || at > size_ - n)
      fail_at_byte(at, std::string("the file ends before ") + field + "; it has " + std::to_string(size_) + " bytes");
  }

  const unsigned char* data_;
  size_t size_;
};

// Where the rays lie in a file and how their flux becomes lumens. Columns are floats; 0 stands for one that is missing,
// as the first is always x.
struct RayTable {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  size_t begin = 0, count = 0, columns = 7;  // rays from byte `begin`; x y z and the direction are the first six
  double metres = 1;                         // in a unit of length
  size_t flux = 6;                           // column
  double lumens_per_unit = 1;                // of that column; ignored where one of the next two is there
  size_t wavelength = 0;                     // column; the flux is then radiant, W
  double nanometres = 1;                     // in a unit of it
  size_t spectrum = 0;                       // column of the index into `efficacy`, from 1
  std::vector<double> efficacy;              // lm/W of each spectrum
  // Totals that the header states: what the rays' fluxes are scaled to, the first that is finite and > 0.
  double total_lm = unknown, total_units = unknown;
  const char* unit = "lm";  // of the flux column
};

// Throws ParseError where fewer rays are there than `table` says, or one has no position or direction. Appends to
// out.warnings, sets out.rays, out.distribution.
void read_rays(const FileBytes& file, const RayTable& table, Photometry& out);

// A Photometry without light, to be filled.
Photometry dark_photometry();

Photometry read_tm25(const FileBytes& file);

}  // namespace photometry
