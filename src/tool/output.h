// The files of `ups render --out`: images and tables of every sensor; whether files can be written. Called by the
// commands that render.
#pragma once
#include <string>
#include <vector>

#include "tool/commands.h"
#include "tool/handles.h"
#include "report/findings.h"
#include "report/map.h"

namespace ups::tool {

// Throws Failure where the folder cannot be made or takes no file: better before a long render than after it.
void prepare_folder(const std::string& folder);
// The same of the folder that `path`, the value of `option`, lies in; it is not made.
void prepare_file(const std::string& option, const std::string& path);
// Throws Failure where a folder stands in the place of a file that the render will write, or a file that it reads.
void prepare_files(const RenderOptions& options, const LoadedScene& scene);

// Each file on its own: one that cannot be written does not take the others with it.
struct Written {
  std::vector<std::string> errors, warnings;  // each names its file
  std::vector<std::string> failed;            // files of the errors: what lies there is of before
};
// Runs write(path); what it throws becomes an error that names the file.
template <class Write>
void attempt(Written& written, const std::string& path, Write&& write) {
  try {
    write(path);
  } catch (const std::exception& e) {
    const std::string message = e.what();
    written.failed.push_back(path);
    written.errors.push_back(message.find(path) == std::string::npos ? path + ": " + message : message);
  }
}
// map, picture: how its maps and its cameras' pictures look.
Written write_outputs(const std::string& folder, const LoadedScene& scene, const ups_result* result,
                      const MapStyle& map, const PictureOptions& picture);

}  // namespace ups::tool
