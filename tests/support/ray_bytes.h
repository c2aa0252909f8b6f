// Ray files in memory, as their formats lay them out: for tests that read them.
#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace ups::test {

// Little-endian, as every machine that the tests run on.
class ByteWriter {
 public:
  ByteWriter& text(const std::string& s) { return raw(s.data(), s.size()); }
  ByteWriter& u32(uint32_t v) { return raw(&v, 4); }
  ByteWriter& u64(uint64_t v) { return raw(&v, 8); }
  ByteWriter& f32(std::initializer_list<double> values) {
    for (double v : values) {
      const float f = float(v);
      raw(&f, 4);
    }
    return *this;
  }
  // Zeros up to a size.
  ByteWriter& pad_to(size_t size) {
    bytes_.resize(size, '\0');
    return *this;
  }
  size_t size() const { return bytes_.size(); }
  const std::string& bytes() const { return bytes_; }

 private:
  ByteWriter& raw(const void* data, size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
    return *this;
  }
  std::string bytes_;
};

struct Tm25Header {
  double luminous_lm = std::numeric_limits<double>::quiet_NaN(), radiant_w = luminous_lm, wavelength_nm = luminous_lm;
  uint64_t rays = 0;
  uint32_t spectral = 0, tables = 0, additional = 0, text_size = 0;
  // Radiant flux, wavelength, luminous flux, Stokes, tristimulus, spectrum index.
  bool radiant = false, wavelength = false, luminous = true, stokes = false, tristimulus = false, spectrum = false;
  std::string name, maker;
};

// 36288 bytes; what follows is the caller's: spectral tables, names of columns, text, rays.
inline ByteWriter tm25_header(const Tm25Header& h) {
  ByteWriter w;
  w.text("TM25").u32(2013).u32(0).f32({h.luminous_lm, h.radiant_w}).u64(h.rays).text("2026-01-01T00:00:00+00:00");
  w.pad_to(56).u32(0).u32(h.spectral).f32({h.wavelength_nm, 380, 780}).u32(h.tables).u32(h.additional).u32(h.text_size);
  w.pad_to(256).u32(1).u32(1);
  for (bool flag : {h.radiant, h.wavelength, h.luminous, h.stokes, h.tristimulus, h.spectrum}) w.u32(flag);
  for (char c : h.name) w.u32(uint8_t(c));
  w.pad_to(288 + 4000);
  for (char c : h.maker) w.u32(uint8_t(c));
  return w.pad_to(36288);
}

struct FileRay {
  double p_mm[3], direction[3], flux_lm;
};

inline std::string tm25_bytes(const std::vector<FileRay>& rays, Tm25Header header = {}) {
  header.rays = rays.size();
  ByteWriter w = tm25_header(header);
  for (const FileRay& r : rays)
    w.f32({r.p_mm[0], r.p_mm[1], r.p_mm[2], r.direction[0], r.direction[1], r.direction[2], r.flux_lm});
  return w.bytes();
}

}  // namespace ups::test
