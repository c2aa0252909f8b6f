// How a file is written: whole or not at all (platform/files.h). Called by the writers of the extras and by the
// program's output.
#pragma once
#include <string>

#include "common/boundary.h"
#include "platform/files.h"

namespace ups::extras {

inline void write_file(const std::string& path, const void* bytes, size_t size) {
  require(!path.empty(), "the path of the file to write is empty");
  try {
    platform::replace_file(path, bytes, size);
  } catch (const std::system_error& e) {
    if (e.code() == std::errc::not_enough_memory) throw std::bad_alloc();
    throw Error(UPS_ERROR_IO, e.what());
  }
}

}  // namespace ups::extras
