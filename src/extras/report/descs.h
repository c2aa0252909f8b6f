// What the C API's callers say, checked, as the parts of the library take it. Called by report.cpp.
#pragma once
#include <string>

#include "report/lit_scene.h"
#include "report/map.h"
#include "report/page.h"
#include "ups/ups_report.h"

namespace ups::report {

ups_report_style_desc style_defaults();
ups_report_map_desc map_defaults();
ups_report_page_desc page_defaults();

struct Style {
  MapStyle map;
  double zoom;
};
Style style_of(const ups_report_style_desc* given);  // null: the defaults

struct Map {
  MapData data;
  Style style;
};
Map map_of(const ups_report_map_desc& desc);  // map_desc.cpp
std::string page_of(const ups_report_page_desc& desc);  // page_desc.cpp

// The scene with these sensors, whose names are looked up by the others.
// result: NULL, or it must be of the scene as it was committed last.
LitScene lit_scene_of(const ups_scene* scene, const ups_result* result, const ups_report_sensor* sensors,
                      uint32_t count);

// "count" and array of a desc fit.
void require_array(const void* array, uint32_t count, const char* name);
inline std::string text_of(const char* text, const char* otherwise = "") { return text ? text : otherwise; }

}  // namespace ups::report
