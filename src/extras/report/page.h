// A render as one page that a lighting designer hands in, for screens and for A4 paper, without any other
// file and without the network. report_page.cpp puts the sections together; each has a file of its own, page_*.cpp.
#pragma once
#include <string>
#include <vector>

#include "report/drawing.h"
#include "report/html.h"
#include "report/map.h"
#include "report/findings.h"
#include "report/targets.h"

namespace ups::report {

struct PageInput {
  const LitScene& scene;
  const ups_result* result;
  const Report& report;
  const Targets* targets;  // null: none were given
  MapStyle map;            // how maps look
  std::string title;
  std::string repeat;      // the command or words by which the same is found again; empty: not told
  std::string date;        // as people read it; empty: not told
  // Of a camera, by its place among the scene's sensors: a PNG file's bytes; empty: none is shown.
  std::function<std::vector<uint8_t>(size_t sensor)> picture;
};

std::string report_page(const PageInput& in);

// ---- sections; without a body there is none

struct Section {
  std::string id, title, body;  // body: HTML
};

struct LuminaireType;
std::string page_style();
std::string maps_part(const PageInput& in);  // of the section on illuminance
Section summary_section(const PageInput& in);
Section targets_section(const PageInput& in);
Section scene_section(const PageInput& in, const std::vector<LuminaireType>& types);
Section luminaires_section(const PageInput& in, const std::vector<LuminaireType>& types);
Section illuminance_section(const PageInput& in);
Section glare_section(const PageInput& in);
Section pictures_section(const PageInput& in);
Section flux_section(const PageInput& in);
Section effects_section(const PageInput& in);
Section accuracy_section(const PageInput& in);
Section warnings_section(const PageInput& in);
Section reading_section(const PageInput& in);
Section repeat_section(const PageInput& in);

// ---- numbers as people read them

std::string lux(double value);                      // without its unit
std::string ratio(double value);                    // 0.712
std::string one_decimal(double value);              // 19.4
// "518 to 528", rounded outwards; empty: not known. text: of a number as it is, not of its hundredfold.
std::string interval(double low, double high, std::string (*text)(double));
std::string end_text(double end, int side, std::string (*text)(double));  // one of its ends: side -1 low, 1 high
// "19.3 to 19.6" of a glare rating, rounded outwards; empty: not known, which is -1 alone, as ratings may be below 0.
std::string rating_interval(double low, double high);
std::string with_interval(double value, double low, double high, std::string (*text)(double));  // HTML
// As many decimals as it takes to fall on the same side of `required` as the value does.
std::string beside(double value, double required, std::string (*text)(double));
std::string beside(double value, double required, std::string written);
// Of one requirement, as plain text: "499.6 lx", "no rating"; its 95 % interval, "498.9 to 500.4", empty where not known.
std::string value_text(const TargetVerdict& v);
std::string interval_text(const TargetVerdict& v);
std::string maintenance_text(const PageInput& in);
std::string counted(size_t count, const char* one, const char* many);

// A drawing within the page. title, description: for those who cannot see it.
std::string inline_svg(const Drawing& drawing, const std::string& title, const std::string& description,
                       const std::string& id);

// ---- luminaires of a kind

struct PlacedSource {
  ups_scene_source info;
  std::string name, file;
  Profile profile;  // null: a light or a surface
};
struct LuminaireType {
  std::string file;        // or what it is
  std::string photometry;  // what tells it from others: the file, or what its profile says
  double flux_lm;    // of each, as it is dimmed, new: without the maintenance factor
  double scale;      // that over the flux of its file
  std::vector<PlacedSource> sources;
};
// By file and flux, in the scene's order; sources that emit nothing are left out.
std::vector<LuminaireType> luminaire_types(const LitScene& scene);

// ---- drawings

bool has_plan(const PageInput& in, const std::vector<LuminaireType>& types);  // is there anything with a place?
Drawing plan_drawing(const PageInput& in, const std::vector<LuminaireType>& types);
Drawing section_drawing(const PageInput& in, const std::vector<LuminaireType>& types);
// Errors against seconds, both logarithmic; with foretold times.
Drawing accuracy_drawing(const Report& report, double target);

}  // namespace ups::report
