// ups_photometry.h: profiles from tables and from files.
#include "photometry/photometry.h"

#include <cmath>

#include "api/desc.h"
#include "api/handles.h"
#include "photometry/metrics.h"
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

std::string lines(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& line : list) text += line + "\n";
  return text;
}

std::string text_of(const photometry::Photometry& data, ups_profile_text topic) {
  switch (topic) {
    case UPS_PROFILE_TEXT_WARNINGS:
      return lines(data.warnings);
    case UPS_PROFILE_TEXT_FORMAT:
      return data.format;
    case UPS_PROFILE_TEXT_KEYWORDS: {
      std::string text;
      for (const photometry::Keyword& k : data.keywords) text += k.name + "=" + k.value + "\n";
      return text;
    }
    default:
      check::enumeration(topic, UPS_PROFILE_TEXT_FORMAT, "topic", "UPS_PROFILE_TEXT_*");
      return {};
  }
}

ups_profile_info info_of(const photometry::Photometry& data) {
  const photometry::Distribution& d = data.distribution;
  ups_profile_info info{};
  info.warning_count = uint32_t(data.warnings.size());
  info.flux_lm = d.band_flux_lm();
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
  return info;
}
static_assert(int(photometry::OpeningShape::sphere) == UPS_OPENING_SPHERE);
static_assert(int(photometry::Symmetry::quadrants) == UPS_SYMMETRY_QUADRANTS);

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
  write_defaults(desc, struct_size, ups_profile_desc{});
}

ups_status ups_profile_create(ups_context* context, const ups_profile_desc* desc, ups_profile** out) {
  return guard(__func__, [&] {
    require(context, "context");
    require(out, "out");
    const ups_profile_desc d = read_desc(desc, &ups_profile_desc_init);
    photometry::Photometry data{make_distribution(d)};
    data.symmetry = d.c_count == 1 ? photometry::Symmetry::axial : photometry::Symmetry::none;
    data.format = "table";
    take(*context, std::move(data), out);
  });
}

ups_status ups_profile_parse(ups_context* context, const void* bytes, size_t size, ups_profile_format format,
                             ups_profile** out) {
  return guard(__func__, [&] {
    require(context, "context");
    require(out, "out");
    if (size > 0) check::pointer(bytes, "bytes");  // an empty file's message is the parser's
    check::enumeration(format, UPS_PROFILE_EULUMDAT, "format", "UPS_PROFILE_*");
    if (format == UPS_PROFILE_EULUMDAT)
      throw Error(UPS_ERROR_UNSUPPORTED, "format: EULUMDAT is not read by this version; an IES LM-63 file is");
    take(*context, format == UPS_PROFILE_AUTO ? photometry::read(bytes, size) : photometry::read_ies(bytes, size), out);
  });
}

ups_status ups_profile_get_info(const ups_profile* profile, ups_profile_info* info) {
  return guard(__func__, [&] { write_info(info, info_of(*require(profile, "profile").data), "info"); });
}

ups_status ups_profile_get_text(const ups_profile* profile, ups_profile_text topic, char* text, size_t capacity,
                                size_t* needed) {
  return guard(__func__, [&] { copy_text(text_of(*require(profile, "profile").data, topic), text, capacity, needed); });
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
      check::require(gamma_deg[i] >= 0 && gamma_deg[i] <= 180,
                     element + " is " + std::to_string(gamma_deg[i]) + "; it must lie in [0, 180]");
      check::require(i == 0 || gamma_deg[i] > gamma_deg[i - 1], element + " is not greater than the one before");
    }
    for (size_t i = 0; i + 1 < count; ++i)
      flux_lm[i] = photometry::zonal_flux_lm(data, gamma_deg[i], gamma_deg[i + 1], photometry::FluxRule::band);
  });
}

ups_status ups_profile_get_beam(const ups_profile* profile, float c_deg, float fraction, ups_profile_beam* beam) {
  return guard(__func__, [&] {
    const photometry::Photometry& data = *require(profile, "profile").data;
    check::require(std::isfinite(c_deg), "c_deg is not finite");
    check::require(fraction > 0 && fraction <= 1,
                   "fraction is " + std::to_string(fraction) + "; it must be greater than 0 and at most 1");
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

void ups_profile_destroy(ups_profile* profile) { delete profile; }
