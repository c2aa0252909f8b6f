// See process.h.
#include "platform/process.h"

#include "platform/windows/system.h"

namespace ups::platform {

std::string program_file() {
  std::wstring file(MAX_PATH, L'\0');
  while (true) {
    const DWORD size = GetModuleFileNameW(nullptr, file.data(), DWORD(file.size()));
    if (size == 0) return {};
    if (size < file.size()) return utf8_of(file.substr(0, size).c_str());
    file.resize(2 * file.size());
  }
}

}  // namespace ups::platform
