// See page.h: how the light was found: flux balance, effects and techniques; warnings; how to read and to repeat it.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "report/page.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

std::string result_text(const ups_result* result, ups_result_text topic) {
  return read_text([&](char* to, size_t capacity, size_t* needed) {
    return ups_result_get_text(result, topic, to, capacity, needed);
  });
}

// "caustics: material 9 can focus ..." with the word in bold; underscores are for scripts.
std::vector<std::string> named_lines(const PageInput& in, const std::string& text) {
  std::vector<std::string> items;
  for (const std::string& told : lines_of(text)) {
    const std::string line = for_people(in.scene, told);
    const size_t colon = line.find(": ");
    std::string name = colon == std::string::npos ? "" : line.substr(0, colon);
    if (name.find(' ') == std::string::npos) std::replace(name.begin(), name.end(), '_', ' ');
    items.push_back(name.empty() ? html_text(line)
                                 : "<strong>" + html_text(name) + "</strong>: " + html_text(line.substr(colon + 2)));
  }
  return items;
}

// 482,600; beyond a million "4.26 million".
std::string many(uint64_t count) {
  if (count >= 1000000000) return significant(1e-9 * double(count), 3) + " billion";
  if (count >= 1000000) return significant(1e-6 * double(count), 3) + " million";
  return count < 1000 ? std::to_string(count) : format("%u,%03u", unsigned(count / 1000), unsigned(count % 1000));
}

std::string percent_of(double part, double whole) { return whole > 0 ? format("%.1f", 100 * part / whole) : ""; }

std::string method_name(ups_method method) {
  switch (method) {
    case UPS_METHOD_UPS: return "Unified Path Sampling";
    case UPS_METHOD_PATH_TRACING: return "path tracing";
    case UPS_METHOD_LIGHT_TRACING: return "light tracing";
    case UPS_METHOD_BIDIRECTIONAL: return "bidirectional path tracing";
    case UPS_METHOD_PPM: return "progressive photon mapping";
    case UPS_METHOD_SPPM: return "stochastic progressive photon mapping";
    case UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING: return "bidirectional photon mapping";
    default: return method_word(method);
  }
}

// As the library's own check has it, whose warnings are these.
std::string balance_sentence(const PageInput& in) {
  const std::string warnings = result_text(in.result, UPS_TEXT_WARNINGS);
  if (warnings.find("the flux balance does not close") != std::string::npos)
    return "The difference is larger than chance explains: see the warnings.";
  if (warnings.find("the balance of eye paths does not close") != std::string::npos)
    return "Light paths lose nothing, but eye paths do: see the warnings.";
  if (warnings.find("paths end after ") != std::string::npos)
    return "Paths were cut, as was asked for: readings lack the light that goes on (see the warnings).";
  return "The balance is closed within chance: no light is lost.";
}

}  // namespace

Section flux_section(const PageInput& in) {
  const ups_result_info& info = in.report.info;
  if (info.absorbed_flux_lm < 0 || info.escaped_flux_lm < 0 || !(info.emitted_flux_lm > 0)) return {};
  const double missing = info.emitted_flux_lm - info.absorbed_flux_lm - info.escaped_flux_lm,
               bound = 2.13 * info.flux_balance_standard_error_lm;  // Student's t of 16 batches
  HtmlTable table{"Flux balance", {"", "lm", "% of emitted"}, {}, 1};
  const auto add = [&](const char* name, double lm) {
    table.rows.push_back({name, lux(lm), percent_of(lm, info.emitted_flux_lm)});
  };
  add("Emitted by the luminaires", info.emitted_flux_lm);
  add("Absorbed by surfaces", info.absorbed_flux_lm);
  add("Escaped from the scene", info.escaped_flux_lm);
  table.rows.push_back({"Difference", format("%.3g", std::abs(missing) < 5e-10 * info.emitted_flux_lm ? 0 : missing),
                        format("%.2g", 100 * missing / info.emitted_flux_lm)});
  std::string text;
  if (info.flux_balance_standard_error_lm >= 0)
    text = format("<p>Expected from chance: \u00b1 %.3g lm (95&nbsp;%%). ", bound) + balance_sentence(in) + "</p>\n";
  return {"flux", "Flux balance", html_table(table, "Flux balance") + text};
}

Section effects_section(const PageInput& in) {
  const std::string effects = html_list(named_lines(in, result_text(in.result, UPS_TEXT_EFFECTS)));
  const std::string techniques = html_list(named_lines(in, result_text(in.result, UPS_TEXT_TECHNIQUES)));
  std::string body;
  if (!effects.empty())
    body += "<h3>Effects of light that the scene can show</h3>\n<p>Each was simulated, with its cause:</p>\n" + effects;
  if (!techniques.empty())
    body += "<h3>Techniques</h3>\n<p>Light was found by " + html_text(method_name(in.report.info.method)) +
            ". Its techniques, and why each was on or off:</p>\n" + techniques;
  if (body.empty()) return {};
  return {"method", "What was simulated, and why", body};
}

Section warnings_section(const PageInput& in) {
  std::vector<std::string> items;
  for (const std::string& line : in.report.advice) items.push_back(html_text(for_people(in.scene, line)));
  for (const std::string& line : in.report.warnings) items.push_back(html_text(line));
  if (items.empty()) return {};
  return {"warnings", "Remarks", html_list(items)};
}

Section reading_section(const PageInput& in) {
  const bool pictures = !in.report.cameras.empty(), meters = !in.report.meters.empty();
  std::vector<std::string> items;
  items.push_back("<strong>Interval, bound</strong>: with 95&nbsp;% confidence the value that the scene as described "
                  "would have lies within. It holds the error of the calculation alone: what the luminaires' files, "
                  "reflectances and dimensions leave open comes on top of it.");
  items.push_back("<strong>Noise</strong>: light is sampled at random; more time makes it smaller, a hundredfold time "
                  "a tenth. <strong>Bias</strong>: where photons are gathered in a small circle, light is smeared by "
                  "its size; it is estimated and part of every bound.");
  if (meters)
    items.push_back("<strong>Minimum, maximum, <i>U</i><sub>0</sub></strong>: the smallest of many noisy values lies "
                    "below the true minimum, the largest above the true maximum; so the interval need not lie evenly "
                    "about the value.");
  if (in.targets && !in.report.targets.empty())
    items.push_back("<strong>Not sure</strong>: the interval holds the required value. A longer calculation makes it "
                    "narrower and will tell.");
  if (pictures)
    items.push_back("<strong>Pictures</strong> are tone-mapped for a display and say nothing of numbers.");
  return {"reading", "How to read the numbers", html_list(items)};
}

Section repeat_section(const PageInput& in) {
  const ups_result_info& info = in.report.info;
  std::string body = html_facts(
      {{"Scene file", html_text(in.report.scene)},
       {"Method", html_text(method_name(info.method))},
       {"Iterations", std::to_string(info.iterations)},
       {"Seed", std::to_string(info.seed)},
       {"Rendering", duration_text(info.elapsed_s) + " on " + counted(size_t(info.threads), "thread", "threads")},
       {"Paths", many(info.eye_paths) + " from meters and pixels, " + many(info.light_paths) + " from luminaires"},
       {"Program", "ups " + version_number()},
       {"Samples left out", info.dropped_samples ? std::to_string(info.dropped_samples) : ""},
       {"Targets", in.targets ? html_text(in.targets->file) : ""},
       {"Date", html_text(in.date)}});
  if (!in.repeat.empty())
    body += "<p>This gives the same numbers again, on any number of threads:</p>\n<pre><code>" + html_text(in.repeat) +
            "</code></pre>\n";
  return {"repeat", "How it was calculated", body};
}

}  // namespace ups::report
