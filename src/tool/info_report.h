// What `ups info` found in each of its files. Filled by the command info, printed by it and by json.cpp.
#pragma once
#include <optional>

#include "tool/data_sheet.h"
#include "tool/profile_file.h"

namespace ups::tool {

struct SceneReport {
  std::string file;
  ups_scene_info info;
  std::vector<SensorEntry> sensors;
  std::vector<std::string> effects, techniques, warnings;
};

struct InfoEntry {
  std::string file, error;  // error: empty where the file could be read and its plots written
  std::string name;         // in the table: of the file, of one in a folder with the folders below that
  std::optional<ProfileReport> profile;
  std::optional<DataSheet> sheet;  // of the profile, where it is printed
  std::optional<SceneReport> scene;
};

std::string list_text(const char* title, const std::vector<std::string>& lines);
std::string table_line(const SceneReport& report, const std::string& name, size_t name_width);
std::string to_json(const std::vector<InfoEntry>& entries);

}  // namespace ups::tool
