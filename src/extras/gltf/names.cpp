// Names that output files and their columns bear: of [A-Za-z0-9._-], each once.
#include "gltf/import.h"

namespace ups::gltf {

namespace {

// File systems take 255; some are left for what follows: "_illuminance.png", a temporary file's suffix.
constexpr size_t max_name_bytes = 200;

// Characters of UTF-8, not its bytes, become one '_' each.
std::string fit_for_files(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool kept =
        (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
    if (kept) {
      result += c;
    } else if ((byte & 0xC0) != 0x80) {
      result += '_';
    }
  }
  return result;
}

// NAME, NAME_2, NAME_3, ...: the first that is not taken yet, nor with `second` after it.
std::string unique_in(UniqueNames& names, const std::string& base, const std::string& second) {
  const auto is_taken = [&](const std::string& name) {
    return names.taken.count(name) || (!second.empty() && names.taken.count(name + second));
  };
  std::string result = base;
  // What is free without `second` alone would be passed over for all that come without it: only those are counted.
  int& next = names.next.try_emplace(base, 2).first->second;
  for (int i = next; is_taken(result); ++i) {
    result = base + "_" + std::to_string(i);
    if (i == next && names.taken.count(result)) ++next;
  }
  names.taken.insert(result);
  if (!second.empty()) names.taken.insert(result + second);
  return result;
}

}  // namespace

// Unique over cameras and meters, as both write NAME.exr. An illuminance camera also writes NAME_illuminance.png.
std::string Importer::unique_name(const std::string& name, bool illuminance, const std::string& where) {
  const std::string result = unique_in(names_, fit_for_files(name), illuminance ? "_illuminance" : "");
  if (result.size() > max_name_bytes) {
    throw extras::Error(UPS_ERROR_PARSE, where + ": the name of its output files has " + std::to_string(result.size()) +
                                             " bytes; at most " + std::to_string(max_name_bytes) + " fit");
  }
  return result;
}

std::string Importer::unique_observer_name(const std::string& name, const std::string& where) {
  if (name.size() > max_name_bytes)
    throw extras::Error(UPS_ERROR_PARSE, where + ": the observer's name has " + std::to_string(name.size()) +
                                             " bytes; at most " + std::to_string(max_name_bytes) + " fit");
  return unique_in(names_, name, "");
}

// A table has the columns NAME_lx and NAME_standard_error_lx.
void Importer::name_source(ups_source_kind kind, uint32_t id, const char* word, const std::string& file) {
  constexpr size_t room = 12;  // for the number
  const uint32_t number = node_name_.empty() ? ++nameless_[word] : 0;
  const std::string base = number ? std::string(word) + "_" + std::to_string(number)
                                  : fit_for_files(node_name_).substr(0, max_name_bytes - room);
  sources.push_back({kind, id, unique_in(source_names_, base, "_standard_error"), file});
  if (kind == UPS_SOURCE_LUMINAIRE) note_place(UPS_GLTF_PART_LUMINAIRE, id, node_where_);
}

void Importer::note_place(ups_gltf_part part, uint32_t id, const std::string& where) {
  places.insert_or_assign({part, id & number_bits}, where);
}

}  // namespace ups::gltf
