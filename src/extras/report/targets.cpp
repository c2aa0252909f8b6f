// See targets.h: names and verdicts.
#include "report/targets.h"

#include <cmath>

#include "report/findings.h"
#include "report/meter_report.h"

namespace ups::report {
namespace {

// The last star takes one letter more wherever what follows it does not fit.
bool matches_from(const char* name, const char* pattern) {
  const char *star = nullptr, *taken = nullptr;
  while (*name) {
    if (*pattern == '*')
      star = pattern++, taken = name;
    else if (*pattern == '?' || *pattern == *name)
      ++pattern, ++name;
    else if (star)
      pattern = star + 1, name = ++taken;
    else
      return false;
  }
  while (*pattern == '*') ++pattern;
  return !*pattern;
}

// A value that is not known to an interval is on neither side for sure.
Judgement judge(double required, double low, double high) {
  if (low < 0 || high < 0 || !std::isfinite(low) || !std::isfinite(high)) return Judgement::not_sure;
  return low >= required ? Judgement::met : high < required ? Judgement::not_met : Judgement::not_sure;
}

bool is_of(const std::string& name, const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns)
    if (matches(name, pattern)) return true;
  return false;
}

void judge_meters(const Targets& targets, size_t index, const MeterReport& meters,
                  std::vector<TargetVerdict>& verdicts) {
  const TargetArea& area = targets.areas[index];
  const ups_meter_statistics& s = meters.statistics;
  const auto add = [&](const char* quantity, double required, double value, double low, double high) {
    if (required < 0) return;
    verdicts.push_back({index, meters.name, quantity, false, required, value, low, high, judge(required, low, high)});
  };
  const bool known = s.mean_error_bound_lx >= 0;
  add("mean_lx", area.mean_lx, s.mean_lx, known ? std::max(0.0, s.mean_lx - s.mean_error_bound_lx) : -1,
      known ? s.mean_lx + s.mean_error_bound_lx : -1);
  add("min_lx", area.min_lx, s.min_lx, s.min_low_lx, s.min_high_lx);
  add("uniformity", area.uniformity, s.uniformity, s.uniformity_low, s.uniformity_high);
}

void judge_observer(const Targets& targets, size_t index, const ObserverReport& observer,
                    std::vector<TargetVerdict>& verdicts) {
  const ups_observer_reading& r = observer.reading;
  const double required = targets.areas[index].ugr, low = double(r.ugr_low), high = double(r.ugr_high);
  Judgement judgement = Judgement::not_sure;
  // What is left out, and makes the rating too low: enough to fail, never to pass.
  const bool lacks = r.flags & (UPS_OBSERVER_UNRATED_SOURCE | UPS_OBSERVER_FIXTURE |
                                UPS_OBSERVER_COVERED_SOURCE | UPS_OBSERVER_LARGE_SOURCE);
  if (r.flags & UPS_OBSERVER_NO_SOURCE)  // nothing in view troubles, or no ray has seen what might
    judgement = high <= required ? Judgement::met : Judgement::not_sure;
  else if (!(r.flags & UPS_OBSERVER_NO_BACKGROUND) && low != -1)  // ratings may be below 0
    judgement = low > required                ? Judgement::not_met
                : high != -1 && high <= required ? Judgement::met
                                                 : Judgement::not_sure;
  if (lacks && judgement == Judgement::met) judgement = Judgement::not_sure;
  verdicts.push_back({index, observer.name, "ugr", true, required, double(r.ugr), low, high, judgement});
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all.empty() ? "none" : all;
}

}  // namespace

bool matches(const std::string& name, const std::string& pattern) {
  return matches_from(name.c_str(), pattern.c_str());
}

void check_names(const Targets& targets, const LitScene& scene) {
  const auto names_of = [&](SensorKind kind, const std::string& meter_kind) {
    std::vector<std::string> names;
    for (const SensorEntry& sensor : scene.sensors)
      if (sensor.info.kind == kind && (meter_kind.empty() || kind_word(sensor.info.meter_kind) == meter_kind))
        names.push_back(sensor.name);
    return names;
  };
  const auto check_all = [&](const TargetArea& area, const std::vector<std::string>& patterns,
                             const std::vector<std::string>& names, const std::string& what) {
    for (const std::string& pattern : patterns) {
      bool found = false;
      for (const std::string& name : names) found = found || matches(name, pattern);
      if (!found)
        throw Failure(targets.file + ": area '" + area.name + "': the scene has no " + what + " '" + pattern +
                      "'; it has " + joined(names));
    }
  };
  for (const TargetArea& area : targets.areas) {
    check_all(area, area.meters, names_of(SensorKind::meters, area.kind),
              area.kind.empty() ? "meters" : area.kind + " meters");
    check_all(area, area.observers, names_of(SensorKind::observer, {}), "observer");
  }
}

std::vector<TargetVerdict> judge(const Targets& targets, const Report& report) {
  std::vector<TargetVerdict> verdicts;
  for (size_t i = 0; i < targets.areas.size(); ++i) {
    for (const MeterReport& meters : report.meters)
      if (is_of(meters.name, targets.areas[i].meters) &&
          (targets.areas[i].kind.empty() || targets.areas[i].kind == meters.kind))
        judge_meters(targets, i, meters, verdicts);
    for (const ObserverReport& observer : report.observers)
      if (is_of(observer.name, targets.areas[i].observers)) judge_observer(targets, i, observer, verdicts);
  }
  return verdicts;
}

const char* judgement_word(Judgement judgement) {
  return judgement == Judgement::met ? "met" : judgement == Judgement::not_met ? "not_met" : "not_sure";
}

}  // namespace ups::report
