// See targets.h: reading the text. Every word is checked, so that a misspelt one is told and not ignored.
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/floating_point.h"
#include "platform/files.h"
#include "platform/paths.h"
#include "report/targets.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

using Json = nlohmann::json;

constexpr const char* part_words = "task, surround, background, cylindrical, walls, ceiling";
constexpr const char* parts[] = {"task", "surround", "background", "cylindrical", "walls", "ceiling"};

[[noreturn]] void fail(const std::string& where, const std::string& problem) {
  throw Failure(where + ": " + problem, UPS_ERROR_PARSE);
}

void allow_only(const Json& object, const std::string& where, const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  if (!object.is_object()) fail(where, "must be an object with " + all);
  for (const auto& [key, value] : object.items())
    if (std::find(words.begin(), words.end(), key) == words.end())
      fail(where, "'" + key + "' is no word of it; those are " + all);
}

// before: what stands before the key where a failure names it, "file: " or "file: areas[0].".
std::string text(const Json& object, const char* key, const std::string& before) {
  if (!object.contains(key)) return {};
  if (!object[key].is_string()) fail(before + key, "must be a text, not " + object[key].dump());
  return object[key].get<std::string>();
}

// A text or a list of them.
std::vector<std::string> texts(const Json& object, const char* key, const std::string& before) {
  std::vector<std::string> all;
  if (!object.contains(key)) return all;
  const Json list = object[key].is_array() ? object[key] : Json::array({object[key]});
  for (const Json& item : list) {
    if (!item.is_string() || item.get<std::string>().empty())
      fail(before + key, "must be a name or a list of names, not " + object[key].dump());
    all.push_back(item.get<std::string>());
  }
  return all;
}

void read_number(const Json& object, const char* key, const std::string& where, double most, double& out) {
  if (!object.contains(key)) return;
  const Json& value = object[key];
  const double number = value.is_number() ? value.get<double>() : -1;
  if (!(number > 0) || !(number <= most))
    fail(where + "." + key, format("must be a number greater than 0 and at most %g, not ", most) + value.dump());
  out = number;
}

void read_light(const Json& object, const std::string& where, TargetArea& area) {
  read_number(object, "mean_lx", where, 1e6, area.mean_lx);
  read_number(object, "min_lx", where, 1e6, area.min_lx);
  read_number(object, "uniformity", where, 1, area.uniformity);
}

void read_room(const Json& object, const std::string& where, TargetArea& area) {
  read_number(object, "ugr", where, 40, area.ugr);
  read_number(object, "colour_rendering", where, 100, area.colour_rendering);
}

struct Row {
  std::string name, reference;
  Json words;
  std::string where;
};
using Rows = std::map<std::string, Row>;

Json parse(const std::string& json, const std::string& file) {
  constexpr int most_depth = 16;  // far more than any words of it have
  const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > most_depth) fail(file, "is nested deeper than targets are");
    return true;
  };
  try {
    const TrapsMasked masked;  // of strtod, where a number is too large
    return Json::parse(json, shallow);
  } catch (const Json::out_of_range& e) {
    fail(file, std::string("has a number that is too large: ") + e.what());
  } catch (const Json::parse_error& e) {
    std::string what = e.what();  // "[json.exception.parse_error.101] parse error at line 3, column 7: ..."
    const size_t begin = what.find("parse error");
    fail(file, "is no JSON: " + (begin == std::string::npos ? what : what.substr(begin)));
  }
}

Json parse_file(const std::string& path) {
  auto file = platform::open_to_read(path);
  if (!file) throw Failure(path + ": cannot be read: " + platform::why_not_open(path), UPS_ERROR_IO);
  return parse({std::istreambuf_iterator<char>(file), {}}, path);
}

void read_rows(const Json& root, const std::string& file, Rows& rows) {
  if (!root.contains("rows")) return;
  if (!root["rows"].is_object()) fail(file + ": rows", "must be an object of rows by their names");
  for (const auto& [key, words] : root["rows"].items()) {
    const std::string where = file + ": rows." + key;
    allow_only(words, where, {"name", "reference", "task", "surround", "background", "cylindrical", "walls", "ceiling",
                              "ugr", "colour_rendering"});
    TargetArea tried;  // so that what is wrong in a row is told, used or not
    for (const char* part : parts) {
      if (!words.contains(part)) continue;
      allow_only(words[part], where + "." + part, {"mean_lx", "min_lx", "uniformity"});
      read_light(words[part], where + "." + part, tried);
    }
    read_room(words, where, tried);
    rows[key] = {text(words, "name", where + "."), text(words, "reference", where + "."), words, where};
  }
}

std::string find_included(const std::string& file, const std::string& name, const std::vector<std::string>& folders) {
  std::string tried;
  for (const std::string& folder : folders) {
    const std::string candidate = platform::joined(folder, name);
    if (platform::is_regular_file(candidate) && platform::lies_within(candidate, folder)) return candidate;
    tried += (tried.empty() ? " in " : " or in ") + folder;
  }
  fail(file + ": include", tried.empty() ? "no folder is given that '" + name + "' could lie in"
                                         : "there is no file '" + name + "'" + tried);
}

void take_row(const Json& words, const std::string& where, const Rows& rows, TargetArea& area) {
  const std::string key = text(words, "row", where + "."),
                    part = words.contains("part") ? text(words, "part", where + ".") : "task";
  if (std::find(std::begin(parts), std::end(parts), part) == std::end(parts))
    fail(where + ".part", "must be one of " + std::string(part_words) + ", not '" + part + "'");
  if (key.empty()) {
    if (words.contains("part")) fail(where + ".part", "is of a row, and no row is named");
    return;
  }
  const auto row = rows.find(key);
  if (row == rows.end()) {
    std::string all;
    for (const auto& [name, content] : rows) all += (all.empty() ? "" : ", ") + name;
    fail(where + ".row", "there is no row '" + key + "'" +
                             (all.empty() ? "; include a file that has it" : "; those that there are: " + all));
  }
  if (row->second.words.contains(part))
    read_light(row->second.words[part], row->second.where, area);
  else if (words.contains("meters"))
    fail(where + ".part", "the row '" + key + "' says nothing of '" + part + "'");
  read_room(row->second.words, row->second.where, area);
  area.kind = part == "cylindrical" ? "cylindrical" : "planar";
  if (part != "task") area.colour_rendering = -1;  // once a room is enough
  area.use = row->second.name.empty() ? key : row->second.name;
  if (part != "task") area.use += " (" + part + ")";
  area.reference = row->second.reference;
}

TargetArea read_area(const Json& words, const std::string& where, const Rows& rows) {
  allow_only(words, where, {"name", "row", "part", "meters", "observers", "mean_lx", "min_lx", "uniformity", "ugr",
                            "colour_rendering"});
  TargetArea area;
  area.meters = texts(words, "meters", where + ".");
  area.observers = texts(words, "observers", where + ".");
  if (area.meters.empty() && area.observers.empty())
    fail(where, "names neither \"meters\" nor \"observers\", so there is nothing to judge");
  take_row(words, where, rows, area);
  read_light(words, where, area);
  read_room(words, where, area);
  if (!area.meters.empty() && area.mean_lx < 0 && area.min_lx < 0 && area.uniformity < 0)
    fail(where, "names meters, but neither a row nor mean_lx, min_lx or uniformity");
  if (!area.observers.empty() && area.ugr < 0) fail(where, "names observers, but neither a row with ugr nor ugr");
  area.name = text(words, "name", where + ".");
  if (area.name.empty()) area.name = area.meters.empty() ? area.observers[0] : area.meters[0];
  return area;
}

}  // namespace

Targets parse_targets(const std::string& json, const std::string& file, const std::vector<std::string>& folders) {
  const Json root = parse(json, file);
  allow_only(root, file, {"standard", "note", "include", "rows", "areas"});
  Targets targets{file, text(root, "standard", file + ": "), text(root, "note", file + ": "), {}};
  Rows rows;
  for (const std::string& name : texts(root, "include", file + ": ")) {
    const std::string included = find_included(file, name, folders);
    const Json other = parse_file(included);
    allow_only(other, included, {"standard", "note", "rows"});
    read_rows(other, included, rows);
    if (targets.standard.empty()) targets.standard = text(other, "standard", included + ": ");
    if (targets.note.empty()) targets.note = text(other, "note", included + ": ");
  }
  read_rows(root, file, rows);
  if (!root.contains("areas") || !root["areas"].is_array() || root["areas"].empty())
    fail(file + ": areas", "must be a list of what is judged, such as [{\"meters\": \"desk*\", \"mean_lx\": 500}]");
  for (size_t i = 0; i < root["areas"].size(); ++i)
    targets.areas.push_back(read_area(root["areas"][i], file + ": areas[" + std::to_string(i) + "]", rows));
  return targets;
}

}  // namespace ups::report
