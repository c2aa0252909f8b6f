// How photometric files are read and written.
#include "tool/profile_file.h"

#include <algorithm>
#include <iterator>

#include "common/atomic_file.h"
#include "platform/files.h"
#include "platform/paths.h"

namespace ups::tool {
namespace {

std::string read_bytes(const std::string& file) {
  auto in = platform::open_to_read(file);
  if (!in) throw Failure("cannot open '" + file + "': " + platform::why_not_open(file));
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string text_of(const ups_profile* profile, ups_profile_text topic) {
  return read_text([&](char* to, size_t capacity, size_t* needed) {
    return ups_profile_get_text(profile, topic, to, capacity, needed);
  });
}

// The one place where bytes become a profile. A TILT file that an IES file names is looked for beside it.
ups_status parse(ups_context* context, const std::string& file, const std::string& bytes, ups_profile_format format,
                 Profile& out) {
  ups_profile_parse_desc desc;
  ups_profile_parse_desc_init(&desc, sizeof desc);
  desc.format = format;
  desc.bytes = bytes.data();
  desc.size = bytes.size();
  ups_profile* profile = nullptr;
  ups_status status = ups_profile_parse_with(context, &desc, &profile);
  if (status != UPS_OK) return status;
  out.reset(profile);
  const std::string tilt_name = text_of(profile, UPS_PROFILE_TEXT_TILT_FILE);
  const std::string tilt_file = tilt_name.empty() ? "" : platform::find_in_any_case(platform::folder_of(file), tilt_name);
  if (tilt_file.empty()) return UPS_OK;
  const std::string tilt = read_bytes(tilt_file);
  desc.tilt_file = tilt.data();
  desc.tilt_file_size = tilt.size();
  status = ups_profile_parse_with(context, &desc, &profile);
  if (status == UPS_OK) out.reset(profile);
  return status;
}

// By what FORMAT tells of a file that was read; all others are XML.
ups_profile_format format_of(const std::string& text) {
  constexpr std::pair<const char*, ups_profile_format> words[] = {{"IES LM-63", UPS_PROFILE_IES_LM63},
                                                                  {"EULUMDAT", UPS_PROFILE_EULUMDAT},
                                                                  {"IES TM-25", UPS_PROFILE_TM25_RAYS},
                                                                  {"Zemax", UPS_PROFILE_ZEMAX_RAYS},
                                                                  {"LightTools", UPS_PROFILE_LIGHTTOOLS_RAYS}};
  for (const auto& [word, format] : words)
    if (text.rfind(word, 0) == 0) return format;
  return UPS_PROFILE_TM33_XML;
}

}  // namespace

std::optional<ups_profile_format> photometric_format(const std::string& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".ies") return UPS_PROFILE_IES_LM63;
  if (extension == ".ldt") return UPS_PROFILE_EULUMDAT;
  if (extension == ".xml") return UPS_PROFILE_TM33_XML;
  if (extension == ".tm25ray") return UPS_PROFILE_TM25_RAYS;
  if (extension == ".sdf" || extension == ".dat") return UPS_PROFILE_ZEMAX_RAYS;
  if (extension == ".ray") return UPS_PROFILE_LIGHTTOOLS_RAYS;
  return std::nullopt;
}

// By its content; where that fails, as its name says.
Profile read_profile(ups_context* context, const std::string& file) {
  const std::string bytes = read_bytes(file);
  Profile profile;
  if (parse(context, file, bytes, UPS_PROFILE_AUTO, profile) == UPS_OK) return profile;
  const std::string by_content = without_functions(ups_last_error());
  const auto named = photometric_format(file);
  if (!named)
    throw Failure(file + ": neither a scene nor a photometric file that is known here, whose name would end in " +
                  ".gltf, .glb, " + known_extensions + "; read as photometry: " + by_content);
  if (parse(context, file, bytes, *named, profile) == UPS_OK) return profile;
  const std::string by_name = without_functions(ups_last_error());
  throw Failure(file + ": " + by_content +
                (by_name == by_content ? ""
                                       : "; read as what its name says, " + lower_extension(file) + ": " + by_name));
}

bool is_scene_file(const std::string& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".gltf" || extension == ".glb") return true;
  char first[4] = {};
  if (platform::is_regular_file(file)) platform::open_to_read(file).read(first, sizeof first);  // a pipe is read once
  return std::equal(first, first + 4, "glTF") || (!photometric_format(file) && first[0] == '{');
}

WrittenProfile make_profile(const std::string& file, const ups_profile* profile) {
  const ups_profile_format format = *photometric_format(file);
  std::string bytes, lacks;
  try {
    bytes = read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_profile_write(profile, format, to, capacity, needed);
    });
    lacks = read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_profile_get_write_warnings(profile, format, to, capacity, needed);
    });
  } catch (const Failure& e) {
    throw Failure(file + ": " + e.what());
  }
  return {std::move(bytes), lines_of(lacks)};
}

ProfileReport report_of_file(const std::string& file, const ups_profile* profile) {
  ProfileReport report = make_report(file, profile);
  const auto named = photometric_format(file);
  if (named && *named != format_of(report.format))
    report.warnings.push_back("its name ends in " + lower_extension(file) + ", but it is " + report.format +
                              " by its content and read as that");
  return report;
}

}  // namespace ups::tool
