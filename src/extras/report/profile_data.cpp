// See profile_data.h.
#include "report/profile_data.h"

#include <algorithm>
#include <cmath>

namespace ups::report {
namespace {

std::string text_of(const ups_profile* profile, ups_profile_text topic) {
  return read_text([&](char* to, size_t capacity, size_t* needed) {
    return ups_profile_get_text(profile, topic, to, capacity, needed);
  });
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

}  // namespace

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

}  // namespace ups::report
