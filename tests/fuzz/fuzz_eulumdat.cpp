// Fuzz target of the EULUMDAT reader: any bytes, some with the second lamp set.
#include <cstdint>

#include "fuzz/round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  photometry::ReadOptions options;
  options.lamp_set = size % 8 == 1;
  try {
    return photometry::fuzz::one_input([&] { return photometry::read_eulumdat(bytes, size, options); });
  } catch (const std::invalid_argument&) {  // no such lamp set
    return 0;
  }
}
