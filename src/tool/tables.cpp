#include "tool/tables.h"

#include <cstdio>

#include "common/atomic_file.h"

namespace ups::tool {

namespace {

class Csv {
 public:
  explicit Csv(std::string header) : text_(std::move(header) + "\n") {}
  void add(double value) {
    char number[40];
    std::snprintf(number, sizeof number, "%s%.9g", at_start_ ? "" : ",", value == 0 ? 0.0 : value);  // no "-0"
    text_ += number;
    at_start_ = false;
  }
  void end_row() {
    text_ += "\n";
    at_start_ = true;
  }
  void write(const std::string& path) const { extras::write_file(path, text_.data(), text_.size()); }

 private:
  std::string text_;
  bool at_start_ = true;
};

}  // namespace

std::vector<std::string> source_names(const ups_result* result) {
  uint32_t count = 0;
  check(ups_result_get_source_count(result, &count));
  std::vector<std::string> names;
  for (uint32_t i = 0; i < count; ++i) {
    ups_source_info info{};
    info.struct_size = sizeof info;
    check(ups_result_get_source(result, i, &info));
    const char* kind = info.kind == UPS_SOURCE_GROUP ? "group_" : info.kind == UPS_SOURCE_INSTANCE ? "instance_" : "luminaire_";
    names.push_back(kind + std::to_string(info.id));
  }
  return names;
}

void write_sources_csv(const std::string& path, const std::vector<double>& positions_m, const SensorEntry& meters,
                       const ups_result* result) {
  std::string header = "x_m,y_m,z_m";
  std::vector<std::vector<ups_meter_reading>> columns;
  for (const std::string& name : source_names(result)) {
    header += "," + name + "_lx," + name + "_standard_error_lx";
    std::vector<ups_meter_reading>& column = columns.emplace_back(meters.info.meter_count);
    check(ups_result_read_source_meters(result, uint32_t(columns.size() - 1), meters.info.sensor, column.data(), column.size()));
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

void write_goniometer_csv(const std::string& path, const SensorEntry& goniometer, const ups_result* result) {
  const ups_sensor_id id = goniometer.info.sensor;
  std::vector<float> c(goniometer.info.columns), gamma(goniometer.info.rows);
  check(ups_result_get_goniometer_angles(result, id, c.data(), c.size(), gamma.data(), gamma.size()));
  std::vector<ups_intensity_reading> nodes(c.size() * gamma.size());
  check(ups_result_read_goniometer(result, id, nodes.data(), nodes.size()));
  Csv csv("c_deg,gamma_deg,intensity_cd,standard_error_cd,bias_cd,error_bound_cd");
  for (size_t i = 0; i < nodes.size(); ++i) {
    for (float value : {c[i / gamma.size()], gamma[i % gamma.size()], nodes[i].intensity_cd, nodes[i].standard_error_cd,
                        nodes[i].bias_cd, nodes[i].error_bound_cd})
      csv.add(double(value));
    csv.end_row();
  }
  csv.write(path);
}

}  // namespace ups::tool
