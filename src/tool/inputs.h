// What a scene is read from must not be replaced by what is found of it. Called by the commands that write files.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace ups::tool {

using Output = std::pair<std::string, std::string>;  // an option, a file that will be written for it

// scene: its file, which was imported. Throws Failure where an output is that file, or one that it names.
void spare_inputs(const std::string& scene, const std::vector<Output>& outputs);

}  // namespace ups::tool
