// See goniometer_report.h: the worst node, keywords of the written file, and the measurement as text.
#include "tool/goniometer_report.h"

#include <algorithm>
#include <cmath>

#include "report/intervals.h"
#include "tool/report.h"
#include "tool/tables.h"
#include "tool/text_format.h"

namespace ups::tool {

namespace {

constexpr double blur_to_mention = 0.02;
constexpr double share_of_peak = 0.05;  // the floor of ups_goniometer_info's relative errors

using Seed = unsigned long long;  // as printf has it

// Of a share, which may be known to far more digits than percent_text has.
std::string error_text(double fraction) { return fraction < 0 ? "unknown" : format("%.2g %%", 100 * fraction); }

bool mostly_blur(const NodeError& e) {
  return e.relative_error_bound > blur_to_mention && 2 * e.relative_blur > e.relative_error_bound;
}

NodeError worst_of(const GoniometerNodes& nodes, double peak) {
  NodeError worst{0, 0, -1, 0};
  for (size_t i = 0; i < nodes.readings.size(); ++i) {
    const ups_intensity_reading& r = nodes.readings[i];
    const double scale = std::max(double(r.intensity_cd), share_of_peak * peak), relative = r.error_bound_cd / scale;
    if (r.error_bound_cd < 0) return {0, 0, -1, 0};
    if (relative > worst.relative_error_bound)
      worst = {nodes.c_deg_of(i), nodes.gamma_deg_of(i), relative, std::abs(r.bias_cd) / scale};
  }
  return worst;
}

ups_interval peak_interval(const GoniometerNodes& nodes, uint32_t iterations) {
  std::vector<ups_interval> all;
  for (const ups_intensity_reading& r : nodes.readings) {
    const double value = double(r.intensity_cd), bound = double(r.error_bound_cd);
    all.push_back({value, bound < 0 ? -1 : std::max(0.0, value - bound), bound < 0 ? -1 : value + bound});
  }
  return greatest_of(all, iterations);
}

}  // namespace

Profile with_keyword(const Profile& profile, const std::string& name, const std::string& value) {
  ups_profile* copy = nullptr;
  check(ups_profile_with_keyword(profile.get(), name.c_str(), value.c_str(), &copy));
  return Profile(copy);
}

Profile make_profile(const ups_result* result, const SensorEntry& goniometer, const Report& render,
                     const std::string& luminaire) {
  ups_profile* taken = nullptr;
  check(ups_result_get_goniometer_profile(result, goniometer.info.sensor, &taken));
  Profile profile(taken);
  const ups_goniometer_info& info = render.goniometers[0].info;
  const auto set = [&](const char* name, const std::string& value) { profile = with_keyword(profile, name, value); };
  // EULUMDAT has 78 characters for it.
  set("TEST", format("UPS %s, worst error %s, %s, %u iterations, seed %llu", version_number().c_str(),
                     percent_text(info.worst_relative_error_bound).c_str(), method_word(render.info.method).c_str(),
                     render.info.iterations, Seed(render.info.seed)));
  set("MANUFAC", "");
  set("LUMINAIRE", luminaire);
  set("LAMP", "the sources of the model");
  const std::string beyond =
      info.outside_flux_lm > 0
          ? format(", of which %s beyond the angles of this table",
                   percent_text(info.light_output_ratio * info.outside_flux_lm / info.flux_lm).c_str())
          : std::string();
  set("OTHER",
      format("light output ratio %s%s, standard error %s; errors of a node's intensity: 95 %%, noise and blur, of at "
             "least 5 %% of the peak: median %s, worst %s",
             percent_text(info.light_output_ratio).c_str(), beyond.c_str(),
             error_text(info.light_output_ratio_standard_error).c_str(),
             percent_text(info.median_relative_error_bound).c_str(),
             percent_text(info.worst_relative_error_bound).c_str()));
  return profile;
}

Measurement measure(const std::string& file, const SensorEntry& goniometer, const ups_result* result,
                    const ups_profile* profile, Report render) {
  const GoniometerNodes nodes = read_goniometer(goniometer, result);
  const auto brighter = [](const ups_intensity_reading& a, const ups_intensity_reading& b) {
    return a.intensity_cd < b.intensity_cd;
  };
  const ups_intensity_reading peak = *std::max_element(nodes.readings.begin(), nodes.readings.end(), brighter);
  Measurement m{std::move(render), make_report(file, profile), worst_of(nodes, double(peak.intensity_cd)), peak,
                peak_interval(nodes, render.info.iterations), {}, {}};
  const auto read_beam = [&](float c_deg, float fraction, ups_goniometer_beam& beam) {
    beam.struct_size = sizeof beam;
    check(ups_result_get_goniometer_beam(result, goniometer.info.sensor, c_deg, fraction, &beam));
  };
  for (int plane = 0; plane < 2; ++plane) {
    read_beam(90.0f * float(plane), 0.5f, m.beam[plane]);
    read_beam(90.0f * float(plane), 0.1f, m.field[plane]);
  }
  return m;
}

std::string to_text(const Measurement& m) {
  const ups_result_info& render = m.render.info;
  const ups_goniometer_info& info = m.info();
  const ups_profile_info& profile = m.profile.info;
  std::string text = format("%s: method %s, %u iterations in %.2f s on %d threads, seed %llu\n", m.render.scene.c_str(),
                            method_word(render.method).c_str(), render.iterations, render.elapsed_s, render.threads,
                            Seed(render.seed));
  text += format("goniometer %s: %u C-planes x %u gamma angles, symmetry %s\n", m.render.goniometers[0].name.c_str(),
                 info.c_count, info.gamma_count, symmetry_word(profile.symmetry));
  const double bound = noise_bound(info.flux_standard_error_lm, render.iterations),
               of_ratio = noise_bound(info.light_output_ratio_standard_error, render.iterations);
  text += format("flux balance, lm:\n  emitted by the sources  %12.6g\n  absorbed in the scene   %12.6g\n",
                 info.emitted_flux_lm, info.absorbed_flux_lm);
  text += format("  out of the scene        %12.6g%s\n", info.flux_lm, bound_text(bound, "").c_str());
  text += format("  unaccounted for         %12.2g\n", m.residual_lm());
  if (info.outside_flux_lm > 0)
    text += format("  beyond the range of gamma, in no reading: %.6g of what is out\n", info.outside_flux_lm);
  text += format("light output ratio: %s%s\n", percent_text(info.light_output_ratio).c_str(),
                 bound_text(of_ratio < 0 ? -1 : 100 * of_ratio, " %").c_str());
  const ups_interval& peak = m.peak_interval;
  text += format("peak: %.6g cd%s, at C %g deg, gamma %g deg\n", peak.value,
                 peak.low < 0 ? " +- unknown" : format(" (95 %%: %.6g to %.6g)", peak.low, peak.high).c_str(),
                 profile.peak_c_deg, profile.peak_gamma_deg);
  text += beams_text(m.profile);
  text += format("flux of the table: %.6g lm as interpolated, %.6g lm by the band rule of other programs\n",
                 profile.interpolated_flux_lm, profile.flux_lm);
  text += format("error of a node (95 %%, of at least 5 %% of the peak): median %s, worst %s",
                 percent_text(info.median_relative_error_bound).c_str(),
                 percent_text(m.worst.relative_error_bound).c_str());
  if (m.worst.relative_error_bound >= 0)
    text += format(" at C %g deg, gamma %g deg, of that blur %s%s", m.worst.c_deg, m.worst.gamma_deg,
                   percent_text(m.worst.relative_blur).c_str(),
                   mostly_blur(m.worst) ? ": a finer grid lessens it, more iterations do not" : "");
  text += "\n";
  for (const std::string& warning : m.render.warnings) text += "warning: " + warning + "\n";
  return text;
}

}  // namespace ups::tool
