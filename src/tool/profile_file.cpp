// How photometric files are read and what is asked of their profiles.
#include "tool/profile_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "common/atomic_file.h"

namespace ups::tool {
namespace {

std::string read_bytes(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw Failure("cannot open '" + file + "'");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string text_of(const ups_profile* profile, ups_profile_text topic) {
  return read_text([&](char* to, size_t capacity, size_t* needed) {
    return ups_profile_get_text(profile, topic, to, capacity, needed);
  });
}

// The file of that name beside `file`, in any case; empty where there is none. A name with folders is taken without
// them.
std::string file_beside(const std::string& file, const std::string& name) {
  const auto lower = [](std::string text) {
    for (char& c : text)
      if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return text;
  };
  const std::string wanted = lower(name.substr(name.find_last_of("/\\") + 1));
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::error_code error;
  for (auto entry = std::filesystem::directory_iterator(folder.empty() ? "." : folder, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (!wanted.empty() && lower(entry->path().filename().string()) == wanted && entry->is_regular_file(error))
      return entry->path().string();
  }
  return {};
}

// The one place where bytes become a profile. A TILT file that an IES file names is looked for beside it.
ups_status parse(ups_context* context, const std::string& file, Profile& out) {
  const std::string bytes = read_bytes(file);
  ups_profile_parse_desc desc;
  ups_profile_parse_desc_init(&desc, sizeof desc);
  desc.format = photometric_format(file).value_or(UPS_PROFILE_AUTO);
  desc.bytes = bytes.data();
  desc.size = bytes.size();
  ups_profile* profile = nullptr;
  ups_status status = ups_profile_parse_with(context, &desc, &profile);
  if (status != UPS_OK) return status;
  out.reset(profile);
  const std::string tilt_name = text_of(profile, UPS_PROFILE_TEXT_TILT_FILE);
  const std::string tilt_file = tilt_name.empty() ? "" : file_beside(file, tilt_name);
  if (tilt_file.empty()) return UPS_OK;
  const std::string tilt = read_bytes(tilt_file);
  desc.tilt_file = tilt.data();
  desc.tilt_file_size = tilt.size();
  status = ups_profile_parse_with(context, &desc, &profile);
  if (status == UPS_OK) out.reset(profile);
  return status;
}

std::vector<float> directions_of(const std::vector<std::pair<double, double>>& c_gamma_deg) {
  std::vector<float> directions;
  for (const auto& [c, gamma] : c_gamma_deg) {
    const double sine = std::sin(gamma * radian);
    directions.push_back(float(sine * std::cos(c * radian)));
    directions.push_back(float(sine * std::sin(c * radian)));
    directions.push_back(float(-std::cos(gamma * radian)));
  }
  return directions;
}

ups_profile_beam beam_of(const ups_profile* profile, float c_deg, float fraction) {
  ups_profile_beam beam{};
  beam.struct_size = sizeof beam;
  check(ups_profile_get_beam(profile, c_deg, fraction, &beam));
  return beam;
}

}  // namespace

std::string lower_extension(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  }
  return extension;
}

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

Profile read_profile(ups_context* context, const std::string& file) {
  Profile profile;
  if (parse(context, file, profile) != UPS_OK) throw Failure(file + ": " + without_functions(ups_last_error()));
  return profile;
}

void write_profile(const std::string& file, const ups_profile* profile) {
  std::string bytes;
  try {
    bytes = read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_profile_write(profile, *photometric_format(file), to, capacity, needed);
    });
  } catch (const Failure& e) {
    throw Failure(file + ": " + e.what());
  }
  extras::write_file(file, bytes.data(), bytes.size());
}

std::vector<float> intensities(const ups_profile* profile, const std::vector<std::pair<double, double>>& c_gamma_deg) {
  std::vector<float> values(c_gamma_deg.size());
  check(ups_profile_eval(profile, directions_of(c_gamma_deg).data(), values.size(), values.data()));
  return values;
}

ProfileReport make_report(const std::string& file, const ups_profile* profile) {
  ProfileReport report{};
  report.file = file;
  report.info.struct_size = sizeof report.info;
  check(ups_profile_get_info(profile, &report.info));
  report.format = text_of(profile, UPS_PROFILE_TEXT_FORMAT);
  report.tilt_table = text_of(profile, UPS_PROFILE_TEXT_TILT_TABLE);
  report.warnings = lines_of(text_of(profile, UPS_PROFILE_TEXT_WARNINGS));
  for (const std::string& line : lines_of(text_of(profile, UPS_PROFILE_TEXT_KEYWORDS))) {
    const size_t equals = std::min(line.find('='), line.size());
    report.keywords.emplace_back(line.substr(0, equals), equals < line.size() ? line.substr(equals + 1) : "");
  }
  for (int plane = 0; plane < 2; ++plane) {
    report.beam[plane] = beam_of(profile, 90.f * float(plane), 0.5f);
    report.field[plane] = beam_of(profile, 90.f * float(plane), 0.1f);
  }
  for (size_t i = 0; i < zones_deg.size(); ++i)
    check(ups_profile_get_zonal_flux(profile, zones_deg[i].data(), 2, &report.zonal_flux_lm[i]));
  for (size_t i = 0; i < luminance_c_deg.size(); ++i) {
    std::vector<std::pair<double, double>> angles;
    for (float gamma : luminance_gamma_deg) angles.emplace_back(luminance_c_deg[i], gamma);
    check(ups_profile_get_luminance(profile, directions_of(angles).data(), angles.size(),
                                    report.luminance_cd_m2[i].data()));
  }
  return report;
}

}  // namespace ups::tool
