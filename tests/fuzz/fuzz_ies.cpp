// Fuzz target of the IES LM-63 reader: any bytes, every second input with itself as the TILT file.
#include <cstdint>

#include "fuzz/round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  photometry::ReadOptions options;
  if (size % 2 == 1) options.tilt_file = bytes, options.tilt_file_size = size, options.tilt_deg = double(size % 100);
  return photometry::fuzz::one_input([&] { return photometry::read_ies(bytes, size, options); });
}
