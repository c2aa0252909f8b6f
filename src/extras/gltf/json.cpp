// The only file that includes nlohmann/json (it compiles slowly).
#include "gltf/json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "common/boundary.h"

namespace ups::gltf {

namespace {

// Beyond 2^53 a double does not hold every integer; no number in a scene file is that large.
constexpr double largest_integer = 9007199254740992.0;

// Deeper nesting is no scene; tinygltf, which reads the same text afterwards, walks extras by recursion.
constexpr int max_depth = 128;

Json convert(const nlohmann::json& from, int depth) {
  if (depth > max_depth) {
    throw extras::Error(UPS_ERROR_PARSE, "the JSON is nested deeper than " + std::to_string(max_depth) + " levels");
  }
  Json to;
  if (from.is_object()) {
    to.kind = Json::Kind::object;
    for (const auto& [key, value] : from.items()) to.members.push_back({key, convert(value, depth + 1)});
  } else if (from.is_array()) {
    to.kind = Json::Kind::array;
    to.items.reserve(from.size());
    for (const auto& value : from) to.items.push_back(convert(value, depth + 1));
  } else if (from.is_string()) {
    to.kind = Json::Kind::text;
    to.text = from.get<std::string>();
  } else if (from.is_boolean()) {
    to.kind = Json::Kind::boolean;
    to.boolean = from.get<bool>();
  } else if (from.is_number()) {
    to.kind = Json::Kind::number;
    to.number = from.get<double>();
  }
  return to;
}

nlohmann::json convert(const Json& from) {
  switch (from.kind) {
    case Json::Kind::boolean:
      return from.boolean;
    case Json::Kind::number: {  // tinygltf takes neither 4.0 for a whole number nor a signed one for a count
      const double value = from.number;
      if (std::abs(value) >= largest_integer || value != std::floor(value) || (value == 0 && std::signbit(value)))
        return value;
      return value < 0 ? nlohmann::json(int64_t(value)) : nlohmann::json(uint64_t(value));
    }
    case Json::Kind::text:
      return from.text;
    case Json::Kind::array: {
      nlohmann::json to = nlohmann::json::array();
      for (const Json& item : from.items) to.push_back(convert(item));
      return to;
    }
    case Json::Kind::object: {
      nlohmann::json to = nlohmann::json::object();
      for (const JsonMember& member : from.members) to[member.name] = convert(member.value);
      return to;
    }
    default:
      return nullptr;
  }
}

std::string in_quotes(std::string_view text) {
  std::string result(1, '"');
  result += text;
  return result += '"';
}

std::string number_text(double value) { return short_number(value, 10); }

std::string range_text(double low, double high) {
  if (std::isinf(low)) return "of any size";
  if (high >= largest_integer && high != largest_float) return "at least " + number_text(low);
  return "from " + number_text(low) + " to " + number_text(high);
}

bool within(double value, double low, double high) { return std::isfinite(value) && value >= low && value <= high; }

}  // namespace

const Json* Json::find(std::string_view key) const {
  for (const auto& [name, value] : members) {
    if (name == key) return &value;
  }
  return nullptr;
}

Json parse_json(const char* begin, const char* end) {
  try {
    const TrapsMasked masked;  // of strtod, where a number is too large
    return convert(nlohmann::json::parse(begin, end), 0);
  } catch (const nlohmann::json::exception& e) {
    // "[json.exception.parse_error.101] parse error at line 3, column 7: ..." reads better without its number.
    const std::string text = e.what();
    const size_t bracket = text.find("] ");
    throw extras::Error(UPS_ERROR_PARSE,
                        "bad JSON: " + (bracket == std::string::npos ? text : text.substr(bracket + 2)));
  }
}

std::string json_text(const Json& json) { return convert(json).dump(); }

std::string place(const char* kind, size_t index, const std::string& name) {
  std::string result = kind;
  result += " ";
  result += std::to_string(index);
  if (!name.empty()) (result += ' ') += in_quotes(name);
  return result;
}

const Json& empty_object() {
  static const Json empty = [] {
    Json json;
    json.kind = Json::Kind::object;
    return json;
  }();
  return empty;
}

JsonReader::JsonReader(const Json& object, std::string where) : object_(&object), where_(std::move(where)) {
  if (!object.is_object()) throw extras::Error(UPS_ERROR_PARSE, where_ + " must be a JSON object");
}

void JsonReader::fail(std::string_view key, const std::string& problem) const {
  throw extras::Error(UPS_ERROR_PARSE, where_ + ": " + in_quotes(key) + " " + problem);
}

void JsonReader::allow_only(std::initializer_list<std::string_view> keys) const {
  for (const auto& member : object_->members) {
    bool known = false;
    for (std::string_view key : keys) known = known || key == member.name;
    if (known) continue;
    std::string allowed;
    for (std::string_view key : keys) allowed += (allowed.empty() ? "" : ", ") + in_quotes(key);
    fail(member.name, "is not known here; allowed: " + allowed);
  }
}

std::optional<JsonReader> JsonReader::object(std::string_view key) const {
  const Json* value = object_->find(key);
  if (!value) return std::nullopt;
  return JsonReader(*value, inside(key));
}

JsonReader JsonReader::object_or_empty(std::string_view key) const {
  const auto found = object(key);
  return found ? *found : JsonReader(empty_object(), inside(key));
}

std::optional<JsonReader> JsonReader::extension(std::string_view name) const {
  const auto extensions = object("extensions");
  return extensions ? extensions->object(name) : std::nullopt;
}

std::optional<JsonReader> JsonReader::ups_extras() const {
  const Json* extras = object_->find("extras");
  const Json* ups = extras ? extras->find("ups") : nullptr;
  if (!ups) return std::nullopt;
  return JsonReader(*ups, where_ + ": extras.ups");
}

// `node 3 "desk": extras.ups` + `meters` reads `node 3 "desk": extras.ups.meters`.
std::string JsonReader::inside(std::string_view key) const {
  return where_ + (where_.find(": ") == std::string::npos ? ": " : ".") + std::string(key);
}

const std::vector<Json>& JsonReader::array(std::string_view key) const {
  static const std::vector<Json> none;
  const Json* value = object_->find(key);
  if (!value) return none;
  if (!value->is_array()) fail(key, "must be an array");
  return value->items;
}

double JsonReader::number(std::string_view key, double fallback, double low, double high) const {
  const Json* value = object_->find(key);
  if (!value) return fallback;
  if (value->kind != Json::Kind::number || !within(value->number, low, high)) {
    fail(key, "must be a number " + range_text(low, high));
  }
  return value->number;
}

int64_t JsonReader::integer(std::string_view key, int64_t fallback, int64_t low, int64_t high) const {
  const Json* value = object_->find(key);
  if (!value) return fallback;
  const double limit = std::min(double(high), largest_integer);
  if (value->kind != Json::Kind::number || !within(value->number, double(low), limit) ||
      value->number != std::floor(value->number)) {
    fail(key, "must be a whole number " + range_text(double(low), double(high)));
  }
  return int64_t(value->number);
}

bool JsonReader::boolean(std::string_view key, bool fallback) const {
  const Json* value = object_->find(key);
  if (!value) return fallback;
  if (value->kind != Json::Kind::boolean) fail(key, "must be true or false");
  return value->boolean;
}

std::string JsonReader::text(std::string_view key, const std::string& fallback) const {
  const Json* value = object_->find(key);
  if (!value) return fallback;
  if (value->kind != Json::Kind::text) fail(key, "must be a text");
  return value->text;
}

std::optional<std::vector<double>> JsonReader::numbers(std::string_view key, size_t count, double low,
                                                       double high) const {
  const Json* value = object_->find(key);
  if (!value) return std::nullopt;
  std::vector<double> result;
  if (value->is_array()) {
    for (const Json& item : value->items) {
      if (item.kind == Json::Kind::number && within(item.number, low, high)) result.push_back(item.number);
    }
  }
  if (result.size() != count || value->items.size() != count) {
    fail(key, "must be an array of " + std::to_string(count) + " numbers, each " + range_text(low, high));
  }
  return result;
}

Rgb JsonReader::rgb(std::string_view key, const Rgb& fallback, double low, double high, bool number_is_grey) const {
  const Json* value = object_->find(key);
  if (!value) return fallback;
  if (number_is_grey && !value->is_array()) {
    if (value->kind != Json::Kind::number || !within(value->number, low, high)) {
      fail(key, "must be a number or an array of 3 numbers, each " + range_text(low, high));
    }
    return {value->number, value->number, value->number};
  }
  const std::vector<double> rgb = *numbers(key, 3, low, high);
  return {rgb[0], rgb[1], rgb[2]};
}

std::vector<Rgb> JsonReader::triples(std::string_view key) const {
  std::vector<Rgb> result;
  for (const Json& item : array(key)) {
    bool good = item.is_array() && item.items.size() == 3;
    Rgb triple{};
    for (size_t i = 0; good && i < 3; ++i) {
      good = item.items[i].kind == Json::Kind::number;
      triple[i] = item.items[i].number;
    }
    if (!good) fail(key, "must be an array of [x, y, z]; its element " + std::to_string(result.size()) + " is not");
    result.push_back(triple);
  }
  return result;
}

}  // namespace ups::gltf
