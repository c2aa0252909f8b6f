// Photometric files of luminaires: each parsed once for the same tilt and lamp set, with the TILT file that an IES file
// may name beside it. Called by light.cpp.
#include "gltf/import.h"
#include "platform/paths.h"

namespace ups::gltf {

namespace {

std::string core_text(const ups_profile* profile, ups_profile_text topic) {
  size_t size = 0;
  if (ups_profile_get_text(profile, topic, nullptr, 0, &size) != UPS_OK) return {};
  std::string text(size, '\0');
  if (ups_profile_get_text(profile, topic, text.data(), size, &size) != UPS_OK) return {};
  text.resize(size ? size - 1 : 0);
  return text;
}

}  // namespace

const ups_profile* Importer::profile(const ProfileFile& file, const std::string& where) {
  const std::string key = file.key + "\n" + std::to_string(file.tilt_deg) + "\n" + std::to_string(file.lamp_set);
  for (const auto& [known, profile] : profiles_) {
    if (known == key) return profile.get();
  }
  ups_profile_parse_desc desc;
  ups_profile_parse_desc_init(&desc, sizeof desc);
  desc.bytes = file.bytes.data();
  desc.size = file.bytes.size();
  desc.tilt_deg = file.tilt_deg;
  desc.lamp_set = file.lamp_set;
  ups_profile* parsed = nullptr;
  check(ups_profile_parse_with(context_, &desc, &parsed), where);
  ProfilePtr profile(parsed);
  const std::string tilt_name = core_text(parsed, UPS_PROFILE_TEXT_TILT_FILE);
  const std::string tilt_path =
      tilt_name.empty() || file.folder.empty() ? "" : platform::find_in_any_case(file.folder, tilt_name);
  if (!tilt_path.empty()) {
    const Bytes tilt = read_beside(document_, tilt_path, where);
    desc.tilt_file = tilt.data();
    desc.tilt_file_size = tilt.size();
    parsed = nullptr;
    check(ups_profile_parse_with(context_, &desc, &parsed), where);
    profile.reset(parsed);
  }
  profiles_.emplace_back(key, std::move(profile));
  const std::string text = core_text(parsed, UPS_PROFILE_TEXT_WARNINGS);
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) warn(file.name + ": " + text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parsed;
}

}  // namespace ups::gltf
