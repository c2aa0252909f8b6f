// See process.h. Not compiled yet.
#include "platform/process.h"

#include <mach-o/dyld.h>

namespace ups::platform {

std::string program_file() {
  uint32_t size = 0;
  _NSGetExecutablePath(nullptr, &size);
  std::string file(size, '\0');
  if (_NSGetExecutablePath(file.data(), &size) != 0) return {};
  file.resize(file.find('\0'));
  return file;
}

}  // namespace ups::platform
