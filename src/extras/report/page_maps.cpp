// See page.h: a false-colour map of each set of meters that lies in a plane.
#include <algorithm>

#include "report/map_data.h"
#include "report/page.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

constexpr size_t most_maps = 16, most_points = 40000;

// In one card of two beside each other, or as wide as the page.
std::string map_of(const PageInput& in, size_t index, bool narrow) {
  const SensorEntry& sensor = in.scene.sensors[index];
  const std::optional<MapData> data = meter_map(sensor, in.scene, in.result);
  if (!data) return {};
  MapStyle style = in.map;
  if (narrow) style.width = std::min(style.width, 560.0), style.most_height = std::min(style.most_height, 440.0);
  const std::string svg =
      inline_svg(map_drawing(*data, style), data->quantity + " of " + sensor.name, map_description(*data, style),
                 "map" + std::to_string(index));
  const std::string name = html_text(sensor.name);
  return html_figure("<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"Map of " + name + "\">\n" +
                         svg + "</div>\n",
                     "", narrow ? "map" : "wide");
}

}  // namespace

std::string maps_part(const PageInput& in) {
  std::vector<size_t> sets;
  for (size_t i = 0; i < in.scene.sensors.size(); ++i) {
    const SensorInfo& info = in.scene.sensors[i].info;
    if (info.kind == SensorKind::meters && info.meter_count >= 4 && info.meter_count <= most_points) sets.push_back(i);
  }
  const bool narrow = sets.size() > 2;
  std::string html;
  for (size_t i = 0; i < sets.size() && i < most_maps; ++i) html += map_of(in, sets[i], narrow);
  if (html.empty()) return {};
  if (sets.size() > most_maps) html += format("<p>The first %zu of %zu.</p>\n", most_maps, sets.size());
  return "<h3>Maps</h3>\n" + (narrow ? "<div class=\"cards maps\">\n" + html + "</div>\n" : html);
}

}  // namespace ups::report
