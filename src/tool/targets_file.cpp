// See targets_file.h.
#include "tool/targets_file.h"

#include <iterator>

#include "platform/files.h"
#include "platform/paths.h"
#include "platform/process.h"

namespace ups::tool {
namespace {

// Where the program's own files of targets are, installed and in the build tree alike.
std::string own_folder() {
  const std::string program = platform::program_file();
  return program.empty() ? "" : platform::simplified(platform::joined(platform::folder_of(program), UPS_TO_TARGETS));
}

}  // namespace

Targets read_targets(const std::string& path) {
  auto file = platform::open_to_read(path);
  if (!file)
    throw Failure(path + ": cannot be read: " + platform::why_not_open(path) +
                  "; --targets wants a JSON file of targets");
  return parse_targets({std::istreambuf_iterator<char>(file), {}}, path, {platform::folder_of(path), own_folder()});
}

}  // namespace ups::tool
