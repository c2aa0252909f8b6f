// See report.h: the report for people.
#include "tool/report.h"

#include <algorithm>
#include <cmath>

#include "report/intervals.h"
#include "report/page.h"
#include "tool/accuracy.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

constexpr float told_share = 0.2f;  // of a reading that a single sample makes: a bright speck

std::string joined(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : ", ") + word;
  return result.empty() ? "none" : result;
}

std::string interval_text(const ups_interval& i, const char* number) {
  if (i.low < 0) return "";
  const std::string both = std::string(" (") + number + " to " + number + ")";
  return format(both.c_str(), i.low, i.high);
}

std::string lumens(double lm) { return lm < 0 ? "unknown" : format("%.6g lm", lm); }

std::string lux(double value, double low, double high) {
  return format("%.6g lx", value) + interval_text({value, low, high}, "%.6g");
}

std::string rating(float value, float low, float high) {
  const std::string text = format("%.1f", double(value)), range = report::rating_interval(double(low), double(high));
  return range.empty() ? text : text + " (" + range + ")";
}

std::string meters_text(const MeterReport& meters) {
  const ups_meter_statistics& s = meters.statistics;
  const std::string kind = meters.kind == "planar" ? "" : " (" + meters.kind + ")";
  if (s.mean_lx < 0) return "meters " + meters.name + kind + ": no iteration has come to them yet\n";
  const double mean_low = s.mean_error_bound_lx < 0 ? -1 : std::max(0.0, s.mean_lx - s.mean_error_bound_lx);
  std::string text =
      format("meters %s%s: mean %s, min %s, max %s, uniformity %.3f%s, diversity %.3f%s, worst error %s\n",
             meters.name.c_str(), kind.c_str(), lux(s.mean_lx, mean_low, s.mean_lx + s.mean_error_bound_lx).c_str(),
             lux(s.min_lx, s.min_low_lx, s.min_high_lx).c_str(), lux(s.max_lx, s.max_low_lx, s.max_high_lx).c_str(),
             s.uniformity, interval_text({s.uniformity, s.uniformity_low, s.uniformity_high}, "%.3f").c_str(),
             s.diversity, interval_text({s.diversity, s.diversity_low, s.diversity_high}, "%.3f").c_str(),
             percent_text(s.worst_relative_error_bound).c_str());
  for (const IntervalAt& a : meters.above)
    text += format("meters %s: %.4g %% at least %.6g lx%s\n", meters.name.c_str(), 100 * a.interval.value, a.at,
                   interval_text({0, 100 * a.interval.low, 100 * a.interval.high}, "%.4g").c_str());
  return text;
}

std::string ratio_text(const RatioReport& r) {
  std::string text = "ratio " + r.numerator + " / " + r.denominator + ": " +
                     (r.ratio.value < 0 ? "unknown" : format("%.4g", r.ratio.value)) + interval_text(r.ratio, "%.4g");
  if (r.points > 0)
    text += format("; meter by meter from %.4g%s to %.4g%s", r.least.value, interval_text(r.least, "%.4g").c_str(),
                   r.greatest.value, interval_text(r.greatest, "%.4g").c_str());
  return text + "\n";
}

// Of sources that no ray has seen.
std::string unseen_text(const ups_observer_reading& r) {
  return std::isfinite(r.ugr_high) ? format("which may rate up to UGR %.1f all the same", double(r.ugr_high))
                                   : "and what one that was missed would rate is not known";
}

std::string observer_text(const ObserverReport& observer) {
  const ups_observer_reading& r = observer.reading;
  std::string text = "observer " + printable(observer.name) + ": ";
  if (r.flags & UPS_OBSERVER_NO_SOURCE)
    text += r.ugr_high == -1 ? "no UGR, as no source of glare is visible"
                             : "no source of glare was seen, " + unseen_text(r);
  else if (r.flags & UPS_OBSERVER_NO_BACKGROUND)
    text += "no UGR, as no indirect light was found";
  else
    text += "UGR " + rating(r.ugr, r.ugr_low, r.ugr_high);
  if (r.ceiling_coverage > 0)
    text += ", GGR " + rating(r.ggr, r.ggr_low, r.ggr_high) +
            format(" (CIE 147: large sources over %.0f %% of the ceiling)", 100 * r.ceiling_coverage);
  text += r.background_cd_m2 < 0
              ? ", background unknown"
              : ", background " + report::significant(double(r.background_cd_m2), 4) + " cd/m^2";
  if (observer.sources.empty()) return text + "\n";
  const GlareSourceReport& worst = observer.sources[0];
  return text + format(", %u sources, the worst %s with %.0f %%\n", r.source_count, worst.name.c_str(),
                       100 * worst.source.share);
}

std::string verdict_text(const TargetVerdict& v, const std::string& area) {
  const bool lux = v.quantity.ends_with("_lx");
  const std::string unit = lux ? " lx" : "", range = report::interval_text(v),
                    what = v.quantity == "ugr" ? "UGR" : lux ? v.quantity.substr(0, v.quantity.size() - 3) : v.quantity;
  std::string verdict = judgement_word(v.judgement);
  std::replace(verdict.begin(), verdict.end(), '_', ' ');
  return "target " + one_line(area) + ": " + (v.at_most ? "observer " : "meters ") + one_line(v.subject) + ": " + what +
         " " + report::value_text(v) + (range.empty() ? "" : " (" + range + ")") + ", required " +
         (v.at_most ? "at most " : "at least ") + format("%.6g", v.required) + unit + ": " + verdict + "\n";
}

}  // namespace

std::string percent_text(double fraction) { return fraction < 0 ? "unknown" : format("%.2f %%", 100 * fraction); }

std::string bound_text(double bound, const char* unit) {
  return bound < 0 ? " +- unknown" : " +- " + report::significant(bound, 2) + unit + " (95 %)";
}

const char* projection_word(ups_projection projection) {
  constexpr const char* words[] = {"perspective", "equidistant", "equisolid", "panorama"};  // UPS_PERSPECTIVE, ...
  return words[projection];
}

std::string to_text(const RenderReport& report) {
  const ups_result_info& info = report.info;
  std::string text = format("%s: method %s, %u iterations in %.2f s on %d threads, seed %llu\n", report.scene.c_str(),
                            method_word(info.method).c_str(), info.iterations, info.elapsed_s, info.threads,
                            static_cast<unsigned long long>(info.seed));
  text += "effects: " + joined(report.effects) + "\ntechniques: " + joined(report.techniques) + "\n";
  text += "flux: emitted " + lumens(info.emitted_flux_lm) + ", absorbed " + lumens(info.absorbed_flux_lm) +
          ", escaped " + lumens(info.escaped_flux_lm) + "\n";
  if (info.maintenance_factor != 1) text += format("maintenance factor: %g\n", info.maintenance_factor);
  for (const MeterReport& meters : report.meters) text += meters_text(meters);
  for (const RatioReport& ratio : report.ratios) text += ratio_text(ratio);
  for (const ObserverReport& observer : report.observers) text += observer_text(observer);
  for (const TargetVerdict& v : report.targets) text += verdict_text(v, report.area_names[v.area]);
  for (const CameraReport& camera : report.cameras) {
    text += format("camera %s: %u x %u, %s, mean luminance %.6g cd/m^2\n", camera.name.c_str(), camera.width,
                   camera.height, projection_word(camera.projection), camera.mean_luminance_cd_m2);
  }
  for (const GoniometerReport& g : report.goniometers) {
    const double bound = noise_bound(g.info.flux_standard_error_lm, info.iterations);
    const double of_ratio = noise_bound(g.info.light_output_ratio_standard_error, info.iterations);
    text += format("goniometer %s: flux %s%s, light output ratio %s%s, median error %s, worst %s\n", g.name.c_str(),
                   lumens(g.info.flux_lm).c_str(), bound_text(bound, "").c_str(),
                   percent_text(g.info.light_output_ratio).c_str(),
                   bound_text(of_ratio < 0 ? -1 : 100 * of_ratio, " %").c_str(),
                   percent_text(g.info.median_relative_error_bound).c_str(),
                   percent_text(g.info.worst_relative_error_bound).c_str());
  }
  for (const SourceReport& source : report.sources)
    text += format("source %s: %.6g lm\n", source.name.c_str(), source.flux_lm);
  for (const PredictionReport& p : report.predictions)
    text += format("accuracy: %s, limited by %s\n", prediction_text(p.relative_error, p.prediction).c_str(),
                   p.prediction.limited_by == UPS_LIMIT_BIAS ? "bias" : "noise");
  if (!report.largest_samples.empty() && report.largest_samples[0].sample.share > told_share) {
    const SampleReport& s = report.largest_samples[0];
    text += format("largest sample: %s of its reading; look into it: %s\n",
                   percent_text(double(s.sample.share)).c_str(), report.replay.c_str());
  }
  for (const std::string& advice : report.advice) text += "advice: " + advice + "\n";
  for (const std::string& warning : report.warnings) text += "warning: " + warning + "\n";
  return text;
}

}  // namespace ups::tool
