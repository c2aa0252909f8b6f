// See process.h.
#include "platform/process.h"

#include "platform/native_path.h"

namespace ups::platform {

std::string program_file() {
  std::error_code error;
  const std::filesystem::path file = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::string() : utf8_of(file);
}

}  // namespace ups::platform
