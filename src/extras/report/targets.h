// What a lighting design has to reach, from a small JSON file (samples/targets/README.md), and whether it does: met and
// not met only where the 95 % interval says so. Called by the C API, the render command and its reports.
#pragma once
#include <string>
#include <vector>

#include "report/lit_scene.h"

namespace ups::report {

struct Report;

struct TargetArea {
  std::string name, use, reference;  // use: of its row, with the standard's reference; either may be empty
  std::vector<std::string> meters, observers;  // names, or patterns with * and ?
  std::string kind;  // of the meters that a part of a row is about (kind_word); empty: any
  double mean_lx = -1, min_lx = -1, uniformity = -1, ugr = -1, colour_rendering = -1;  // < 0: not asked for
};

struct Targets {
  std::string file, standard, note;
  std::vector<TargetArea> areas;
};

// Of a JSON text; file: what messages and the page call it. folders: where files that it includes are looked for, in
// this order. Throws Failure that names the file, the field, and what would be right.
Targets parse_targets(const std::string& json, const std::string& file, const std::vector<std::string>& folders);
// Throws Failure where an area names what the scene has not: better before a long render than after it.
void check_names(const Targets& targets, const LitScene& scene);

enum class Judgement { met, not_met, not_sure };

struct TargetVerdict {
  size_t area;          // of Targets::areas
  std::string subject;  // a set of meters, or an observer
  std::string quantity;  // "mean_lx", "min_lx", "uniformity", "ugr"
  bool at_most;               // the required value is the largest allowed
  double required, value;
  double low, high;           // 95 %; -1: not known
  Judgement judgement;
};
// Area by area, the sets and observers of each in the scene's order.
std::vector<TargetVerdict> judge(const Targets& targets, const Report& report);
const char* judgement_word(Judgement judgement);  // "met", "not_met", "not_sure"

bool matches(const std::string& name, const std::string& pattern);

}  // namespace ups::report
