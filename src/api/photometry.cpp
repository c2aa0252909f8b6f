// ups_photometry.h: profiles from tables and from files, and files from profiles.
#include "photometry/photometry.h"

#include <algorithm>
#include <cmath>

#include "api/desc.h"
#include "api/handles.h"
#include "base/text.h"
#include "photometry/lamps.h"
#include "photometry/metrics.h"
#include "photometry/writer_text.h"
#include "scene/check.h"

using namespace ups;
using namespace ups::api;

namespace {

void take(ups_context& context, photometry::Photometry data, ups_profile** out) {
  auto profile = std::make_unique<ups_profile>();
  profile->data = std::make_shared<const photometry::Photometry>(std::move(data));
  for (const std::string& warning : profile->data->warnings) context.core->log(UPS_LOG_WARNING, "profile: " + warning);
  *out = profile.release();
}

photometry::Distribution make_distribution(const ups_profile_desc& d) {
  const uint64_t values = uint64_t(d.c_count) * d.gamma_count;
  check::require(d.c_count >= 1, "c_count is 0; it must be at least 1");
  check::require(d.gamma_count >= 2, "gamma_count is " + std::to_string(d.gamma_count) + "; it must be at least 2");
  check::require(values <= photometry::Distribution::max_values,
                 "c_count * gamma_count is " + std::to_string(values) + "; it must be at most " +
                     std::to_string(photometry::Distribution::max_values));
  check::require(d.reserved == 0, "reserved is " + std::to_string(d.reserved) + "; it must be 0");
  check::pointer(d.c_deg, "c_deg");
  check::pointer(d.gamma_deg, "gamma_deg");
  check::pointer(d.intensity_cd, "intensity_cd");
  return {{d.c_deg, d.c_deg + d.c_count},
          {d.gamma_deg, d.gamma_deg + d.gamma_count},
          {d.intensity_cd, d.intensity_cd + values}};
}

photometry::Opening make_opening(const ups_profile_desc& d) {
  check::enumeration(d.opening_shape, UPS_OPENING_SPHERE, "opening_shape", "UPS_OPENING_*");
  check::range(d.opening_axis, 0, 2, "opening_axis");
  photometry::Opening opening;
  if (d.opening_shape == UPS_OPENING_POINT) return opening;
  for (int i = 0; i < 3; ++i) check::range(d.opening_m[i], 0, 1e6, check::element("opening_m", size_t(i)));
  opening.shape = photometry::OpeningShape(d.opening_shape);
  std::copy(std::begin(d.opening_m), std::end(d.opening_m), opening.size_m);
  opening.axis = d.opening_axis;
  return opening;
}

photometry::Photometry parse(const ups_profile_parse_desc& d) {
  if (d.size > 0) check::pointer(d.bytes, "bytes");  // an empty file's message is the parser's
  check::enumeration(d.format, UPS_PROFILE_LIGHTTOOLS_RAYS, "format", "UPS_PROFILE_*");
  if (d.tilt_file_size > 0) check::pointer(d.tilt_file, "tilt_file");
  check::finite(d.tilt_deg, "tilt_deg");
  const photometry::ReadOptions options{d.tilt_file, d.tilt_file_size, d.tilt_deg, d.lamp_set};
  switch (d.format) {
    case UPS_PROFILE_AUTO:
      return photometry::read(d.bytes, d.size, options);
    case UPS_PROFILE_IES_LM63:
      return photometry::read_ies(d.bytes, d.size, options);
    case UPS_PROFILE_EULUMDAT:
      return photometry::read_eulumdat(d.bytes, d.size, options);
    case UPS_PROFILE_TM33_XML:
      return photometry::read_tm33(d.bytes, d.size, options);
    default:  // of ray files the first bytes tell
      return photometry::read_ray_file(d.bytes, d.size, options);
  }
}

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
  return text;
}

void set_keyword(photometry::Photometry& data, const std::string& given, const std::string& value) {
  constexpr size_t longest_name = 64, longest_value = 1000;
  const std::string name = upper(given);
  if (name.empty() || name.size() > longest_name ||
      name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") != std::string::npos)
    fail_argument("name: '" + photometry::cut(given, longest_name) +
                  "' is no keyword; it must be 1 to 64 letters, digits or _");
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  if (value.size() > longest_value || std::any_of(value.begin(), value.end(), is_control))
    fail_argument("value: of " + name + "; it must be one line of at most 1000 bytes without control characters");
  if (!photometry::is_utf8(value.data(), value.size())) fail_argument("value: of " + name + "; it must be UTF-8");
  std::vector<photometry::Keyword>& all = data.keywords;
  const auto same = [&](const photometry::Keyword& k) { return upper(k.name) == name; };
  const auto first = std::find_if(all.begin(), all.end(), same);
  if (first == all.end()) {
    all.push_back({name, value});
    return;
  }
  *first = {name, value};
  all.erase(std::remove_if(first + 1, all.end(), same), all.end());
}

// Of what is listed line by line, in a C string.
std::string as_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r' || c == '\0') c = ' ';
  return text;
}

std::string values_of(const photometry::Photometry& data, std::string name) {
  name = upper(std::move(name));
  std::string text;
  for (const photometry::Keyword& k : data.keywords)
    if (upper(k.name) == name) text += (text.empty() ? "" : "\n") + as_line(k.value);
  return text;
}

// One field of all lamp sets, a line each.
std::string lamp_lines(const photometry::Photometry& data, std::string photometry::LampSet::*field) {
  std::string text;
  for (const photometry::LampSet& set : data.lamp_sets) text += photometry::one_line(set.*field) + "\n";
  return text;
}

std::string text_of(const photometry::Photometry& data, ups_profile_text topic) {
  switch (topic) {
    case UPS_PROFILE_TEXT_WARNINGS:
      return lines(data.warnings);
    case UPS_PROFILE_TEXT_FORMAT:
      return data.format;
    case UPS_PROFILE_TEXT_TILT_FILE:
      return as_line(data.tilt_file_name);
    case UPS_PROFILE_TEXT_KEYWORDS: {
      std::string text;
      for (const photometry::Keyword& k : data.keywords) text += as_line(k.name) + "=" + as_line(k.value) + "\n";
      return text;
    }
    case UPS_PROFILE_TEXT_TILT_TABLE: {
      std::string text;
      for (size_t i = 0; i < data.tilt.angle_deg.size(); ++i)
        text += photometry::shortest(data.tilt.angle_deg[i]) + " " + photometry::shortest(data.tilt.factor[i]) + "\n";
      return text;
    }
    case UPS_PROFILE_TEXT_LAMP_TYPES:
      return lamp_lines(data, &photometry::LampSet::type);
    case UPS_PROFILE_TEXT_LAMP_COLOURS:
      return lamp_lines(data, &photometry::LampSet::colour);
    case UPS_PROFILE_TEXT_LAMP_RENDERINGS:
      return lamp_lines(data, &photometry::LampSet::colour_rendering);
    default:
      check::enumeration(topic, UPS_PROFILE_TEXT_LAMP_RENDERINGS, "topic", "UPS_PROFILE_TEXT_*");
      return {};
  }
}

ups_profile_lamp_set lamp_set_of(const photometry::Photometry& data, uint32_t index) {
  const size_t n = data.lamp_sets.size();
  check::require(index < n, "index is " + std::to_string(index) + "; the file has " + std::to_string(n) +
                                (n == 1 ? " lamp set, 0" : " lamp sets, from 0"));
  const photometry::LampSet& lamps = data.lamp_sets[index];
  ups_profile_lamp_set out{};
  out.count = lamps.count;
  out.flux_lm = lamps.flux_lm;
  out.input_power_w = float(lamps.power_w);
  out.colour_temperature_k = float(photometry::colour_temperature_k(lamps));
  out.colour_rendering_index = float(photometry::colour_rendering_index(lamps));
  out.chosen = data.lamps_shine_together || index == data.lamp_set;
  return out;
}

std::string written(const photometry::Photometry& data, ups_profile_format format,
                    std::vector<std::string>* warnings = nullptr) {
  check::enumeration(format, UPS_PROFILE_LIGHTTOOLS_RAYS, "format", "UPS_PROFILE_*");
  if (format != UPS_PROFILE_IES_LM63 && format != UPS_PROFILE_EULUMDAT)
    throw Error(UPS_ERROR_UNSUPPORTED, "format: IES_LM63 and EULUMDAT are written, no other");
  return format == UPS_PROFILE_EULUMDAT ? photometry::write_eulumdat(data, warnings)
                                        : photometry::write_ies(data, warnings);
}

ups_profile_info info_of(const photometry::Photometry& data) {
  const photometry::Distribution& d = data.distribution;
  ups_profile_info info{};
  info.warning_count = uint32_t(data.warnings.size());
  info.flux_lm = photometry::flux_lm(data);
  info.interpolated_flux_lm = d.interpolated_flux_lm();
  info.rated_flux_lm = data.rated_flux_lm;
  info.input_power_w = data.input_power_w;
  info.peak_cd = float(d.peak_cd());
  info.peak_c_deg = float(d.peak_c_deg());
  info.peak_gamma_deg = float(d.peak_gamma_deg());
  std::copy(std::begin(data.opening.size_m), std::end(data.opening.size_m), info.opening_m);
  info.opening_shape = ups_opening_shape(data.opening.shape);  // both enumerations count alike
  info.symmetry = ups_profile_symmetry(data.symmetry);
  info.c_count = uint32_t(d.c_deg().size());
  info.gamma_count = uint32_t(d.gamma_deg().size());
  info.photometric_type = ups_photometric_type(data.type);
  info.ray_count = uint32_t(data.rays.size());
  info.down_flux_lm = photometry::zonal_flux_lm(data, 0, 90, photometry::FluxRule::band);
  info.up_flux_lm = std::max(0.0, info.flux_lm - info.down_flux_lm);
  const double lamps = photometry::lamp_flux_lm(data);
  info.light_output_ratio = lamps > 0 ? info.flux_lm / lamps : -1;
  for (int i = 0; i < 2; ++i) {
    info.beam_angle_deg[i] = float(photometry::beam_of(data, photometry::Metrics::plane_deg[i], 0.5).angle_deg);
    info.field_angle_deg[i] = float(photometry::beam_of(data, photometry::Metrics::plane_deg[i], 0.1).angle_deg);
  }
  info.opening_axis = data.opening.axis;
  info.lamp_set_count = uint32_t(data.lamp_sets.size());
  return info;
}
static_assert(int(photometry::OpeningShape::sphere) == UPS_OPENING_SPHERE);
static_assert(int(photometry::Symmetry::quadrants) == UPS_SYMMETRY_QUADRANTS);
static_assert(int(photometry::PhotometricType::b) == UPS_PHOTOMETRIC_B);
static_assert(int(photometry::PhotometricType::a) == UPS_PHOTOMETRIC_A);

// values[i] = function(direction i), the directions checked before the first value is written.
template <class Function>
void for_directions(const float* directions_xyz, size_t count, float* values, const char* name, Function&& function) {
  if (count == 0) return;
  check::pointer(directions_xyz, "directions_xyz");
  check::pointer(values, name);
  const auto direction = [&](size_t i) {
    return Vec3d(directions_xyz[3 * i], directions_xyz[3 * i + 1], directions_xyz[3 * i + 2]);
  };
  for (size_t i = 0; i < count; ++i)
    if (!(is_finite(direction(i)) && length2(direction(i)) > 0))
      fail_argument("directions_xyz: element " + std::to_string(i) +
                    " is not a direction; it must be finite and not 0");
  for (size_t i = 0; i < count; ++i) values[i] = float(function(direction(i)));
}

}  // namespace

void ups_profile_desc_init(ups_profile_desc* desc, uint32_t struct_size) {
  ups_profile_desc d{};
  d.opening_axis = 2;
  d.input_power_w = -1;
  write_defaults(desc, struct_size, d);
}

void ups_profile_parse_desc_init(ups_profile_parse_desc* desc, uint32_t struct_size) {
  ups_profile_parse_desc d{};
  d.tilt_deg = -1;
  write_defaults(desc, struct_size, d);
}

ups_status ups_profile_create(ups_context* context, const ups_profile_desc* desc, ups_profile** out) {
  return guard(__func__, [&] {
    require(context, "context");
    require(out, "out");
    const ups_profile_desc d = read_desc(desc, &ups_profile_desc_init);
    photometry::Photometry data{make_distribution(d)};
    data.symmetry = d.c_count == 1 ? photometry::Symmetry::axial : photometry::Symmetry::none;
    data.format = "table";
    data.opening = make_opening(d);
    check::finite(d.input_power_w, "input_power_w");
    if (d.input_power_w >= 0) data.input_power_w = d.input_power_w;
    take(*context, std::move(data), out);
  });
}

ups_status ups_profile_parse(ups_context* context, const void* bytes, size_t size, ups_profile_format format,
                             ups_profile** out) {
  return guard(__func__, [&] {
    require(context, "context");
    require(out, "out");
    ups_profile_parse_desc d;
    ups_profile_parse_desc_init(&d, sizeof d);
    d.format = format, d.bytes = bytes, d.size = size;
    take(*context, parse(d), out);
  });
}

ups_status ups_profile_parse_with(ups_context* context, const ups_profile_parse_desc* desc, ups_profile** out) {
  return guard(__func__, [&] {
    require(context, "context");
    require(out, "out");
    take(*context, parse(read_desc(desc, &ups_profile_parse_desc_init)), out);
  });
}

ups_status ups_profile_write(const ups_profile* profile, ups_profile_format format, char* bytes, size_t capacity,
                             size_t* needed) {
  return guard(__func__, [&] {
    const photometry::Photometry& data = *require(profile, "profile").data;
    copy_text(written(data, format), bytes, capacity, needed);
  });
}

ups_status ups_profile_get_write_warnings(const ups_profile* profile, ups_profile_format format, char* text,
                                          size_t capacity, size_t* needed) {
  return guard(__func__, [&] {
    std::vector<std::string> warnings;
    written(*require(profile, "profile").data, format, &warnings);
    copy_text(lines(warnings), text, capacity, needed);
  });
}

ups_status ups_profile_get_info(const ups_profile* profile, ups_profile_info* info) {
  return guard(__func__, [&] { write_info(info, info_of(*require(profile, "profile").data), "info"); });
}

ups_status ups_profile_get_lamp_set(const ups_profile* profile, uint32_t index, ups_profile_lamp_set* set) {
  return guard(__func__, [&] { write_info(set, lamp_set_of(*require(profile, "profile").data, index), "set"); });
}

ups_status ups_profile_get_text(const ups_profile* profile, ups_profile_text topic, char* text, size_t capacity,
                                size_t* needed) {
  return guard(__func__, [&] { copy_text(text_of(*require(profile, "profile").data, topic), text, capacity, needed); });
}

ups_status ups_profile_get_keyword(const ups_profile* profile, const char* name, char* text, size_t capacity,
                                   size_t* needed) {
  return guard(__func__, [&] {
    const photometry::Photometry& data = *require(profile, "profile").data;
    copy_text(values_of(data, &require(name, "name")), text, capacity, needed);
  });
}

ups_status ups_profile_with_keyword(const ups_profile* profile, const char* name, const char* value,
                                    ups_profile** out) {
  return guard(__func__, [&] {
    const photometry::Photometry& data = *require(profile, "profile").data;
    const std::string key = &require(name, "name"), text = &require(value, "value");
    require(out, "out");
    auto copy = std::make_shared<photometry::Photometry>(data);
    set_keyword(*copy, key, text);
    *out = new ups_profile{.data = std::move(copy)};
  });
}

ups_status ups_profile_eval(const ups_profile* profile, const float* directions_xyz, size_t count,
                            float* intensity_cd) {
  return guard(__func__, [&] {
    const photometry::Distribution& distribution = require(profile, "profile").data->distribution;
    for_directions(directions_xyz, count, intensity_cd, "intensity_cd",
                   [&](const Vec3d& d) { return distribution.eval(d.x, d.y, d.z); });
  });
}

ups_status ups_profile_get_luminance(const ups_profile* profile, const float* directions_xyz, size_t count,
                                     float* luminance_cd_m2) {
  return guard(__func__, [&] {
    const photometry::Photometry& data = *require(profile, "profile").data;
    for_directions(directions_xyz, count, luminance_cd_m2, "luminance_cd_m2",
                   [&](const Vec3d& d) { return photometry::luminance_cd_m2(data, d.x, d.y, d.z); });
  });
}

ups_status ups_profile_get_zonal_flux(const ups_profile* profile, const float* gamma_deg, size_t count,
                                      double* flux_lm) {
  return guard(__func__, [&] {
    const photometry::Photometry& data = *require(profile, "profile").data;
    check::require(count >= 2, "count is " + std::to_string(count) + "; it must be at least 2, the edges of one zone");
    check::pointer(gamma_deg, "gamma_deg");
    check::pointer(flux_lm, "flux_lm");
    for (size_t i = 0; i < count; ++i) {
      const std::string element = "gamma_deg: element " + std::to_string(i);
      check::require(std::isfinite(gamma_deg[i]) && gamma_deg[i] >= 0 && gamma_deg[i] <= 180,
                     element + " is " + check::text(double(gamma_deg[i])) + "; it must lie in [0, 180]");
      check::require(i == 0 || gamma_deg[i] > gamma_deg[i - 1], element + " is not greater than the one before");
    }
    std::vector<double> zones;
    for (size_t i = 0; i + 1 < count; ++i)
      zones.push_back(photometry::zonal_flux_lm(data, gamma_deg[i], gamma_deg[i + 1], photometry::FluxRule::band));
    std::copy(zones.begin(), zones.end(), flux_lm);
  });
}

ups_status ups_profile_get_beam(const ups_profile* profile, float c_deg, float fraction, ups_profile_beam* beam) {
  return guard(__func__, [&] {
    const photometry::Photometry& data = *require(profile, "profile").data;
    check::require(std::isfinite(c_deg), "c_deg is not finite");
    check::require(fraction > 0 && fraction <= 1,
                   "fraction is " + check::text(double(fraction)) + "; it must be greater than 0 and at most 1");
    const photometry::Beam b = photometry::beam_of(data, c_deg, fraction);
    ups_profile_beam out{};
    out.peak_cd = float(b.peak_cd);
    out.peak_deg = float(b.peak_deg);
    out.from_deg = float(b.from_deg);
    out.to_deg = float(b.to_deg);
    out.angle_deg = float(b.angle_deg);
    write_info(beam, out, "beam");
  });
}

void ups_profile_destroy(ups_profile* profile) { destroy(profile); }
