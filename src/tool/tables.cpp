// See tables.h: columns named by node or group; nodes of a goniometer with their errors.
#include "tool/tables.h"

#include "tool/csv.h"

namespace ups::tool {

void write_sources_csv(const std::string& path, const std::vector<double>& positions_m,
                       const std::vector<size_t>& listed, const SensorEntry& meters,
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
  for (const size_t m : listed) {
    for (size_t k = 0; k < 3; ++k) csv.add_place(positions_m[3 * m + k]);
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
