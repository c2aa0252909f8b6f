// See page.h: a false-colour map of each set of meters that lies in a plane.
#include "tool/map_data.h"
#include "tool/page.h"

namespace ups::tool {
namespace {

constexpr size_t most_maps = 16, most_points = 40000;

// In one card of two beside each other, or as wide as the page.
std::string map_of(const PageInput& in, uint32_t index, bool narrow) {
  const SensorEntry& sensor = in.scene.sensors[index];
  const std::optional<MapData> data = meter_map(sensor, index, in.scene, in.result);
  if (!data) return {};
  MapStyle style = in.map;
  if (narrow) style.width = 560, style.most_height = 440;
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
  std::vector<uint32_t> sets;
  for (uint32_t i = 0; i < in.scene.sensors.size(); ++i) {
    const ups_gltf_sensor_info& info = in.scene.sensors[i].info;
    if (info.kind == UPS_GLTF_METERS && info.meter_count >= 4 && info.meter_count <= most_points) sets.push_back(i);
  }
  const bool narrow = sets.size() > 2;
  std::string html;
  for (size_t i = 0; i < sets.size() && i < most_maps; ++i) html += map_of(in, sets[i], narrow);
  if (html.empty()) return {};
  return "<h3>Maps</h3>\n" + (narrow ? "<div class=\"cards maps\">\n" + html + "</div>\n" : html);
}

}  // namespace ups::tool
