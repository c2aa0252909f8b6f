// How photometric files are read and what is asked of their profiles.
#include "tool/profile_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/atomic_file.h"
#include "platform/paths.h"

namespace ups::tool {
namespace {

std::string read_bytes(const std::string& file) {
  auto in = platform::open_to_read(file);
  if (!in || platform::is_folder(file)) throw Failure("cannot open '" + file + "'");
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

// A ripple about the level is not a lobe: one rises to 60 % at least. Around the circle from the beam's end to its
// start.
std::vector<Lobe> other_lobes(const ups_profile* profile, double c_deg, const ups_profile_beam& beam) {
  constexpr double level = 0.5, clearly = 0.6, step_deg = 0.1;
  if (beam.angle_deg < 0) return {};
  const double length = 360.0 - beam.angle_deg;
  const int count = std::max(1, int(length / step_deg));
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(beam.to_deg + length * (i + 0.5) / count);
  const std::vector<float> values = intensities_in_plane(profile, c_deg, angles);
  const auto edge = [&](double inside, double outside) {
    for (int i = 0; i < 30; ++i) {
      const double middle = 0.5 * (inside + outside);
      const bool above = intensities_in_plane(profile, c_deg, {middle})[0] >= level * beam.peak_cd;
      (above ? inside : outside) = middle;
    }
    return inside;
  };
  std::vector<Lobe> lobes;
  for (int i = 1; i + 1 < count; ++i) {
    if (values[i] < level * beam.peak_cd) continue;
    const int first = i;
    while (i + 1 < count && values[i + 1] >= level * beam.peak_cd) ++i;
    if (i + 1 == count) break;  // adjoins the beam
    if (*std::max_element(&values[first], &values[i] + 1) < clearly * beam.peak_cd) continue;
    const double from = edge(angles[first], angles[first - 1]), to = edge(angles[i], angles[i + 1]);
    const double turn = 360 * std::round(0.5 * (from + to) / 360);
    lobes.push_back({from - turn, to - turn});
  }
  return lobes;
}

// One line each lamp set, empty ones as well.
std::vector<std::string> lamp_texts(const ups_profile* profile, ups_profile_text topic, size_t count) {
  const std::string text = text_of(profile, topic);
  std::vector<std::string> lines(count);
  for (size_t i = 0, begin = 0; i < count && begin < text.size(); ++i) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    lines[i] = text.substr(begin, end - begin);
    begin = end + 1;
  }
  return lines;
}

std::vector<LampSetReport> lamp_sets_of(const ups_profile* profile, uint32_t count) {
  std::vector<LampSetReport> sets(count);
  const auto types = lamp_texts(profile, UPS_PROFILE_TEXT_LAMP_TYPES, count),
             colours = lamp_texts(profile, UPS_PROFILE_TEXT_LAMP_COLOURS, count),
             renderings = lamp_texts(profile, UPS_PROFILE_TEXT_LAMP_RENDERINGS, count);
  for (uint32_t i = 0; i < count; ++i) {
    sets[i].info.struct_size = sizeof sets[i].info;
    check(ups_profile_get_lamp_set(profile, i, &sets[i].info));
    sets[i].type = types[i];
    sets[i].colour = colours[i];
    sets[i].rendering = renderings[i];
  }
  return sets;
}

std::optional<PlaneReport> peak_plane_of(const ups_profile* profile, const ProfileReport& report) {
  constexpr double missed = 0.99;
  const ups_profile_info& info = report.info;
  if (!(std::max(report.beam[0].peak_cd, report.beam[1].peak_cd) < missed * info.peak_cd)) return std::nullopt;
  const float c_deg = std::fmod(std::fmod(info.peak_c_deg, 180.f) + 180.f, 180.f);
  return PlaneReport{c_deg, beam_of(profile, c_deg, 0.5f), beam_of(profile, c_deg, 0.1f)};
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

std::string lower_extension(const std::string& file) {
  std::string extension = platform::extension_of(file);
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
  platform::open_to_read(file).read(first, sizeof first);
  return std::equal(first, first + 4, "glTF") || (!photometric_format(file) && first[0] == '{');
}

WrittenProfile write_profile(const std::string& file, const ups_profile* profile) {
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
  extras::write_file(file, bytes.data(), bytes.size());
  return {std::move(bytes), lines_of(lacks)};
}

std::vector<float> intensities(const ups_profile* profile, const std::vector<std::pair<double, double>>& c_gamma_deg) {
  std::vector<float> values(c_gamma_deg.size());
  check(ups_profile_eval(profile, directions_of(c_gamma_deg).data(), values.size(), values.data()));
  return values;
}

std::vector<float> intensities_in_plane(const ups_profile* profile, double c_deg, const std::vector<double>& angles) {
  std::vector<std::pair<double, double>> c_gamma_deg;
  for (const double angle : angles) {
    const double signed_gamma = std::remainder(angle, 360);
    c_gamma_deg.emplace_back(c_deg + (signed_gamma < 0 ? 180 : 0), std::abs(signed_gamma));
  }
  return intensities(profile, c_gamma_deg);
}

ProfileReport make_report(const std::string& file, const ups_profile* profile) {
  ProfileReport report{};
  report.file = file;
  report.info.struct_size = sizeof report.info;
  check(ups_profile_get_info(profile, &report.info));
  report.format = text_of(profile, UPS_PROFILE_TEXT_FORMAT);
  report.tilt_table = text_of(profile, UPS_PROFILE_TEXT_TILT_TABLE);
  append_once(report.warnings, lines_of(text_of(profile, UPS_PROFILE_TEXT_WARNINGS)));
  report.lamp_sets = lamp_sets_of(profile, report.info.lamp_set_count);
  for (const std::string& line : lines_of(text_of(profile, UPS_PROFILE_TEXT_KEYWORDS))) {
    const size_t equals = std::min(line.find('='), line.size());
    report.keywords.emplace_back(line.substr(0, equals), equals < line.size() ? line.substr(equals + 1) : "");
  }
  for (int plane = 0; plane < 2; ++plane) {
    report.beam[plane] = beam_of(profile, 90.f * float(plane), 0.5f);
    report.field[plane] = beam_of(profile, 90.f * float(plane), 0.1f);
  }
  for (int plane = 0; plane < 2; ++plane) {
    for (ups_profile_beam* beam : {&report.beam[plane], &report.field[plane]}) {
      if (report.is_lit(*beam)) continue;
      beam->from_deg = beam->to_deg = beam->peak_deg;
      beam->angle_deg = -1;
    }
    report.other_lobes[plane] = other_lobes(profile, 90.0 * plane, report.beam[plane]);
  }
  report.peak_plane = peak_plane_of(profile, report);
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

ProfileReport report_of_file(const std::string& file, const ups_profile* profile) {
  ProfileReport report = make_report(file, profile);
  const auto named = photometric_format(file);
  if (named && *named != format_of(report.format))
    report.warnings.push_back("its name ends in " + lower_extension(file) + ", but it is " + report.format +
                              " by its content and read as that");
  return report;
}

}  // namespace ups::tool
