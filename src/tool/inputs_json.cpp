// See inputs.h: the names of files in a scene's JSON, taken as the import takes them, and the tilt files of these.
#include "tool/inputs.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string_view>

#include "base/floating_point.h"
#include "gltf/uri.h"
#include "platform/files.h"
#include "platform/paths.h"
#include "tool/commands.h"

namespace ups::tool {
namespace {

using Json = nlohmann::json;

std::string json_of(const std::string& scene) {
  if (!platform::is_regular_file(scene)) return {};  // a pipe is read once
  constexpr size_t headers = 20;  // glTF 2.0, section 4.4: the file's, then the length and the type of its JSON chunk
  auto in = platform::open_to_read(scene);
  std::string text(headers, '\0');
  in.read(text.data(), std::streamsize(text.size()));
  text.resize(size_t(in.gcount()));
  if (text.size() < headers || !text.starts_with("glTF")) {
    text.append(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    return text;
  }
  const auto byte = [&](size_t i) { return size_t(uint8_t(text[i])); };
  text.resize(byte(12) | byte(13) << 8 | byte(14) << 16 | byte(15) << 24);
  in.read(text.data(), std::streamsize(text.size()));
  text.resize(size_t(in.gcount()));
  return text;
}

std::string_view trimmed(std::string_view text) {
  constexpr const char* blanks = " \t\r";
  const size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

// The file that TILT= of an IES file names, blanks and case free; empty: none.
std::string tilt_file_of(const std::string& file) {
  if (!platform::is_regular_file(file)) return {};
  std::string head(1 << 16, '\0');
  auto in = platform::open_to_read(file);
  in.read(head.data(), std::streamsize(head.size()));
  std::istringstream lines(head.substr(0, size_t(in.gcount())));
  for (std::string line; std::getline(lines, line);) {
    const size_t equals = std::min(line.find('='), line.size());
    std::string word(trimmed(std::string_view(line).substr(0, equals)));
    for (char& c : word)
      if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
    if (word != "TILT" || equals == line.size()) continue;
    const std::string name(trimmed(std::string_view(line).substr(equals + 1)));
    return platform::find_in_any_case(platform::folder_of(file), name);
  }
  return {};
}

// What the import asks for: "uri" of buffers, images and lights, "file" of luminaires wherever extras.ups has them.
class Files {
 public:
  Files(const Json& json, const std::string& folder) : folder_(folder) {
    for (const char* array : {"/buffers", "/images"})
      if (const Json::json_pointer at(array); json.contains(at)) add_uris(json.at(at), false);
    if (const Json::json_pointer at("/extensions/EXT_lights_ies/lights"); json.contains(at)) add_uris(json.at(at), true);
    add_luminaires(json, false);
  }
  std::set<std::string> found;

 private:
  void add(const std::string& name, bool photometric) {
    const std::string file = platform::joined(folder_, name);
    found.insert(platform::resolved(file));
    if (!photometric) return;
    if (const std::string tilt = tilt_file_of(file); !tilt.empty()) found.insert(platform::resolved(tilt));
  }
  void add_uris(const Json& array, bool photometric) {
    for (const Json& item : array) {
      if (const auto at = item.find("uri"); item.is_object() && at != item.end() && at->is_string())
        if (const auto& name = at->get_ref<const std::string&>(); !gltf::is_data_uri(name))
          add(gltf::percent_decoded(name), photometric);
    }
  }
  void add_luminaires(const Json& json, bool ups) {
    for (const auto& [key, value] : json.items()) {
      if (value.is_structured()) add_luminaires(value, ups || key == "ups");
      if (ups && key == "file" && value.is_string()) add(value.get_ref<const std::string&>(), true);
    }
  }
  const std::string folder_;
};

std::set<std::string> files_of(const std::string& scene) {
  std::set<std::string> files = {platform::resolved(scene)};
  const TrapsMasked masked;  // of strtod, where a number is too large
  files.merge(Files(Json::parse(json_of(scene), nullptr, false), platform::folder_of(scene)).found);
  return files;
}

}  // namespace

void spare_inputs(const std::string& scene, const std::vector<Output>& outputs) {
  std::set<std::string> inputs;
  for (const auto& [option, path] : outputs) {
    const std::string file = platform::resolved(path);
    if (file.empty()) continue;  // it replaces nothing
    if (inputs.empty()) inputs = files_of(scene);
    if (inputs.count(file) > 0)
      throw Failure(option + ": would replace the file '" + path + "', which the scene " + scene +
                    " reads; write to another place, or rename one of the two");
  }
}

}  // namespace ups::tool
