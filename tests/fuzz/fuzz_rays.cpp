// Fuzz target of the readers of ray files. A TM-25 file has 36000 bytes of texts between its header and its tables; an
// input leaves them out, so that it can be short, and its first bytes stand for the first text.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "fuzz/round_trip.h"

namespace {

constexpr size_t texts_at = 288, texts_size = 36000;

// The rays themselves: inside what the format allows, and their far field has their flux.
void check_rays(const photometry::Photometry& p) {
  using photometry::fuzz::require;
  double sum = 0;
  for (const photometry::Ray& r : p.rays) {
    double length2 = 0;
    for (int k = 0; k < 3; ++k) {
      require(std::abs(r.p_m[k]) <= 1e6f, "a ray starts within a million metres");
      length2 += double(r.direction[k]) * r.direction[k];
    }
    require(std::abs(length2 - 1) < 1e-5, "a direction is of length 1");
    require(r.flux_lm >= 0 && std::isfinite(r.flux_lm), "a flux is finite");
    sum += r.flux_lm;
  }
  require(std::abs(p.distribution.interpolated_flux_lm() - sum) <= 1e-9 * sum, "the far field has the rays' flux");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  std::string file(reinterpret_cast<const char*>(bytes), size);
  if (file.rfind("TM25", 0) == 0 && size >= texts_at) {
    file.insert(texts_at, texts_size, '\0');
    std::copy_n(bytes, std::min<size_t>(size, 256), &file[texts_at]);
  }
  return photometry::fuzz::one_input([&] {
    photometry::Photometry p = photometry::read_ray_file(file.data(), file.size());
    check_rays(p);
    return p;
  });
}
