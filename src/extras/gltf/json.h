// A JSON document as plain values, and a reader of one object that knows its place in the file, so that every message
// can say what was wrong where. Called by the importer for extensions, `extras.ups` and the checks before loading.
#pragma once
#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ups::gltf {

struct JsonMember;

struct Json {
  enum class Kind { null, boolean, number, text, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0;
  std::string text;
  std::vector<Json> items;
  std::vector<JsonMember> members;

  const Json* find(std::string_view key) const;  // null where this is no object or has no such member
  bool is_object() const { return kind == Kind::object; }
  bool is_array() const { return kind == Kind::array; }
};

struct JsonMember {
  std::string name;
  Json value;
};

// Throws extras::Error (UPS_ERROR_PARSE) with line and column.
Json parse_json(const char* begin, const char* end);

std::string json_text(const Json& json);

// The most that a number may be which becomes a float.
inline constexpr double largest_float = std::numeric_limits<float>::max();

const Json& empty_object();

using Rgb = std::array<double, 3>;

// `node 3 "desk"`: how messages name an element of the file.
std::string place(const char* kind, size_t index, const std::string& name);

// Every read_* function throws UPS_ERROR_PARSE, with the place and what would be right, on a value of the wrong kind.
class JsonReader {
 public:
  JsonReader(const Json& object, std::string where);

  const std::string& where() const { return where_; }
  const Json& json() const { return *object_; }
  bool has(std::string_view key) const { return object_->find(key) != nullptr; }
  void allow_only(std::initializer_list<std::string_view> keys) const;

  std::optional<JsonReader> object(std::string_view key) const;
  JsonReader object_or_empty(std::string_view key) const;
  std::optional<JsonReader> extension(std::string_view name) const;  // extensions.name
  std::optional<JsonReader> ups_extras() const;                      // extras.ups; other kinds of extras are ignored
  const std::vector<Json>& array(std::string_view key) const;        // empty where there is none
  double number(std::string_view key, double fallback, double low, double high) const;
  int64_t integer(std::string_view key, int64_t fallback, int64_t low, int64_t high) const;
  bool boolean(std::string_view key, bool fallback) const;
  std::string text(std::string_view key, const std::string& fallback) const;
  std::optional<std::vector<double>> numbers(std::string_view key, size_t count, double low, double high) const;
  Rgb rgb(std::string_view key, const Rgb& fallback, double low, double high, bool number_is_grey) const;
  std::vector<Rgb> triples(std::string_view key) const;  // empty where there is none

  [[noreturn]] void fail(std::string_view key, const std::string& problem) const;

 private:
  std::string inside(std::string_view key) const;

  const Json* object_;
  std::string where_;
};

}  // namespace ups::gltf
