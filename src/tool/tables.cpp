// See tables.h: columns named by node or group; nodes of a goniometer with their errors.
#include "tool/tables.h"

#include "tool/csv.h"

namespace ups::tool {

std::string source_name(const LoadedScene& scene, ups_source_kind kind, uint32_t id) {
  return read_text(
      [&](char* to, size_t capacity, size_t* needed) {
        return ups_gltf_get_source_name(scene.import_result.get(), kind, id, to, capacity, needed);
      },
      ups_gltf_last_error);
}

std::vector<SourceEntry> sources_of(const LoadedScene& scene, const ups_result* result) {
  uint32_t count = 0;
  check(ups_result_get_source_count(result, &count));
  std::vector<SourceEntry> sources(count);
  for (uint32_t i = 0; i < count; ++i) {
    ups_source_info& info = sources[i].info;
    info.struct_size = sizeof info;
    check(ups_result_get_source(result, i, &info));
    sources[i].name = info.kind == UPS_SOURCE_GROUP ? "group_" + std::to_string(info.id)
                                                    : source_name(scene, info.kind, info.id);
  }
  return sources;
}

void write_sources_csv(const std::string& path, const std::vector<double>& positions_m, const SensorEntry& meters,
                       const std::vector<SourceEntry>& sources, const ups_result* result) {
  std::string header = "x_m,y_m,z_m";
  std::vector<std::vector<ups_meter_reading>> columns;
  for (const SourceEntry& source : sources) {
    header += "," + source.name + "_lx," + source.name + "_standard_error_lx";
    std::vector<ups_meter_reading>& column = columns.emplace_back(meters.info.meter_count);
    check(ups_result_read_source_meters(result, uint32_t(columns.size() - 1), meters.info.sensor, column.data(),
                                        column.size()));
  }
  Csv csv(header);
  for (size_t m = 0; m < meters.info.meter_count; ++m) {
    for (size_t k = 0; k < 3; ++k) csv.add(positions_m[3 * m + k]);
    for (const auto& column : columns) {
      csv.add(double(column[m].illuminance_lx));
      csv.add(double(column[m].standard_error_lx));
    }
    csv.end_row();
  }
  csv.write(path);
}

GoniometerNodes read_goniometer(const SensorEntry& goniometer, const ups_result* result) {
  const ups_sensor_id id = goniometer.info.sensor;
  GoniometerNodes nodes{std::vector<float>(goniometer.info.columns), std::vector<float>(goniometer.info.rows), {}};
  std::vector<float>&c = nodes.c_deg, &gamma = nodes.gamma_deg;
  check(ups_result_get_goniometer_angles(result, id, c.data(), c.size(), gamma.data(), gamma.size()));
  nodes.readings.resize(c.size() * gamma.size());
  check(ups_result_read_goniometer(result, id, nodes.readings.data(), nodes.readings.size()));
  return nodes;
}

void write_goniometer_csv(const std::string& path, const SensorEntry& goniometer, const ups_result* result) {
  const GoniometerNodes nodes = read_goniometer(goniometer, result);
  Csv csv("c_deg,gamma_deg,intensity_cd,standard_error_cd,bias_cd,error_bound_cd");
  for (size_t i = 0; i < nodes.readings.size(); ++i) {
    const ups_intensity_reading& r = nodes.readings[i];
    for (float value : {nodes.c_deg_of(i), nodes.gamma_deg_of(i), r.intensity_cd, r.standard_error_cd, r.bias_cd,
                        r.error_bound_cd})
      csv.add(double(value));
    csv.end_row();
  }
  csv.write(path);
}

}  // namespace ups::tool
