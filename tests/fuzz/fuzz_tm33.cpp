// Fuzz target of the TM-33 reader and its XML.
#include <cstdint>

#include "fuzz/round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  return photometry::fuzz::one_input([&] { return photometry::read_tm33(bytes, size); });
}
