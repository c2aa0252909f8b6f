// See output.h: a camera's images and the layers of its techniques; a meter set's table, a grid's also as images;
// folders and files tried out before a render.
#include "tool/output.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "common/atomic_file.h"
#include "tool/csv.h"
#include "tool/drawing_file.h"
#include "tool/map_data.h"
#include "tool/report.h"
#include "tool/tables.h"

namespace ups::tool {

namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

constexpr uint32_t max_exr_side = 65536;  // of ups_exr
constexpr uint32_t max_map_meters = 4000000;

// What an image is of, for whoever opens it years later.
Attributes common_attributes(const ups_result* result) {
  ups_result_info info{};
  info.struct_size = sizeof info;
  check(ups_result_get_info(result, &info));
  return {{"software", "ups " + version_number()},
          {"method", method_word(info.method)},
          {"iterations", std::to_string(info.iterations)},
          {"seed", std::to_string(info.seed)}};
}

void write_exr(const std::string& path, uint32_t width, uint32_t height, const std::vector<ups_exr_channel>& channels,
               const Attributes& attributes) {
  std::vector<ups_exr_attribute> raw;
  for (const auto& [name, value] : attributes) raw.push_back({name.c_str(), value.c_str()});
  check(ups_exr_write(path.c_str(), width, height, channels.data(), uint32_t(channels.size()), raw.data(),
                      uint32_t(raw.size())),
        ups_exr_last_error);
}

// NAME.png, NAME.svg and NAME.pdf of one drawing.
void write_map(Written& written, const std::string& base, const MapData& data, const MapStyle& style) {
  const Words words{data.quantity + ": " + data.title, map_description(data, style)};
  const Drawing drawing = map_drawing(data, style);
  for (const char* ending : {".png", ".svg", ".pdf"})
    attempt(written, base + ending, [&](const std::string& path) { write_drawing(path, drawing, words); });
}

void write_camera_exr(const std::string& path, const SensorEntry& camera, const ups_result* result,
                      Attributes attributes) {
  const auto luminance = read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB);
  const auto error = read_image(result, camera, UPS_CHANNEL_STANDARD_ERROR_RGB);
  const auto robust = read_image(result, camera, UPS_CHANNEL_ROBUST_RGB);
  const auto bias = read_image(result, camera, UPS_CHANNEL_BIAS);
  const auto bound = read_image(result, camera, UPS_CHANNEL_ERROR_BOUND);
  constexpr size_t pixel = 3 * sizeof(float);
  std::vector<ups_exr_channel> channels = {{"R", &luminance[0], pixel, 0},
                                           {"G", &luminance[1], pixel, 0},
                                           {"B", &luminance[2], pixel, 0},
                                           {"standard_error.R", &error[0], pixel, 0},
                                           {"standard_error.G", &error[1], pixel, 0},
                                           {"standard_error.B", &error[2], pixel, 0},
                                           {"robust.R", &robust[0], pixel, 0},
                                           {"robust.G", &robust[1], pixel, 0},
                                           {"robust.B", &robust[2], pixel, 0},
                                           {"bias.Y", bias.data(), 0, 0},
                                           {"error_bound.Y", bound.data(), 0, 0}};
  for (const ups_exr_channel& channel : channels)
    attributes.emplace_back(std::string("unit.") + channel.name, "cd/m^2");
  std::vector<float> illuminance, illuminance_error;
  if (camera.info.illuminance) {
    illuminance = read_image(result, camera, UPS_CHANNEL_ILLUMINANCE);
    illuminance_error = read_image(result, camera, UPS_CHANNEL_ILLUMINANCE_STANDARD_ERROR);
    channels.push_back({"illuminance.Y", illuminance.data(), 0, 0});
    channels.push_back({"standard_error.illuminance.Y", illuminance_error.data(), 0, 0});
    attributes.emplace_back("unit.illuminance.Y", "lx");
    attributes.emplace_back("unit.standard_error.illuminance.Y", "lx");
  }
  write_exr(path, camera.info.width, camera.info.height, channels, attributes);
}

using Layers = std::vector<std::pair<std::string, std::vector<float>>>;

// The sums of both families, then each technique with its weight and without; none where no techniques were asked for.
Layers technique_layers(const SensorEntry& camera, const ups_result* result) {
  uint32_t count = 0;
  check(ups_result_get_technique_count(result, camera.info.sensor, &count));
  Layers layers;
  if (count == 0) return layers;
  layers.emplace_back("path_integration", read_image(result, camera, UPS_CHANNEL_PATH_INTEGRATION_RGB));
  layers.emplace_back("density_estimation", read_image(result, camera, UPS_CHANNEL_DENSITY_ESTIMATION_RGB));
  for (uint32_t i = 0; i < count; ++i) {
    ups_technique_info info{};
    info.struct_size = sizeof info;
    check(ups_result_get_technique(result, camera.info.sensor, i, &info));
    const std::string name = (info.technique == UPS_TECHNIQUE_MERGE ? "merge_s" : "connect_s") +
                             std::to_string(info.light_vertices) + "_t" + std::to_string(info.eye_vertices);
    for (bool weighted : {true, false}) {
      std::vector<float> pixels(layers[0].second.size());
      check(ups_result_read_technique(result, camera.info.sensor, i,
                                      weighted ? UPS_CONTRIBUTION_WEIGHTED : UPS_CONTRIBUTION_UNWEIGHTED, pixels.data(),
                                      0, pixels.size() * sizeof(float)));
      layers.emplace_back(name + (weighted ? ".weighted" : ".unweighted"), std::move(pixels));
    }
  }
  return layers;
}

void write_techniques(const std::string& path, const SensorEntry& camera, const ups_result* result,
                      Attributes attributes) {
  const Layers layers = technique_layers(camera, result);
  if (layers.empty()) return;
  std::vector<std::string> names;
  for (const auto& layer : layers)
    for (const char* channel : {".R", ".G", ".B"}) names.push_back(layer.first + channel);
  std::vector<ups_exr_channel> channels;
  for (size_t i = 0; i < names.size(); ++i)
    channels.push_back({names[i].c_str(), &layers[i / 3].second[i % 3], 3 * sizeof(float), 0});
  attributes.emplace_back("unit", "cd/m^2");
  write_exr(path, camera.info.width, camera.info.height, channels, attributes);
}

void write_camera(Written& written, const std::string& base, const SensorEntry& camera, const ups_result* result,
                  const MapStyle& map, const Attributes& attributes) {
  const uint32_t width = camera.info.width, height = camera.info.height;
  attempt(written, base + ".exr", [&](const std::string& path) { write_camera_exr(path, camera, result, attributes); });
  attempt(written, base + ".png", [&](const std::string& path) {
    const auto luminance = read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB);
    check(ups_ocio_write_png(path.c_str(), luminance.data(), width, height, 0), ups_ocio_last_error);
  });
  attempt(written, base + "_techniques.exr",
          [&](const std::string& path) { write_techniques(path, camera, result, attributes); });
  MapStyle image_map_style = map;
  image_map_style.threshold = 0;  // of meters alone: pixels have no bounds of their own
  attempt(written, base + "_luminance", [&](const std::string& name) {
    const auto luminance = luminance_of(read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB));
    write_map(written, name, image_map(camera.name, "Luminance", "cd/m\u00b2", luminance, width, height),
              image_map_style);
  });
  if (!camera.info.illuminance) return;
  attempt(written, base + "_illuminance", [&](const std::string& name) {
    const auto illuminance = read_image(result, camera, UPS_CHANNEL_ILLUMINANCE);
    write_map(written, name, image_map(camera.name, "Illuminance", "lx", illuminance, width, height), image_map_style);
  });
}

struct MeterTable {
  std::vector<double> positions;
  std::vector<float> normals;
  std::vector<ups_meter_reading> readings;
};

void write_csv(const std::string& path, const MeterTable& table) {
  Csv csv("x_m,y_m,z_m,nx,ny,nz,illuminance_lx,standard_error_lx,bias_lx,error_bound_lx,direct_lx,indirect_lx");
  for (size_t i = 0; i < table.readings.size(); ++i) {
    for (size_t k = 3 * i; k < 3 * i + 3; ++k) csv.add(table.positions[k]);
    for (size_t k = 3 * i; k < 3 * i + 3; ++k) csv.add(double(table.normals[k]));
    const ups_meter_reading& r = table.readings[i];
    for (float value : {r.illuminance_lx, r.standard_error_lx, r.bias_lx, r.error_bound_lx, r.direct_lx, r.indirect_lx})
      csv.add(double(value));
    csv.end_row();
  }
  csv.write(path);
}

// An image's top line is the grid's last row: row 0 stands at the bottom.
void write_grid(Written& written, const std::string& base, const SensorEntry& grid, const MeterTable& table,
                Attributes attributes) {
  const uint32_t columns = grid.info.columns, rows = grid.info.rows;
  std::vector<float> illuminance, error;
  for (uint32_t row = rows; row-- > 0;) {
    for (uint32_t column = 0; column < columns; ++column) {
      const ups_meter_reading& reading = table.readings[size_t(row) * columns + column];
      illuminance.push_back(reading.illuminance_lx);
      error.push_back(reading.standard_error_lx);
    }
  }
  attributes.emplace_back("unit.Y", "lx");
  attributes.emplace_back("unit.standard_error.Y", "lx");
  const std::string path = base + ".exr";
  if (std::max(columns, rows) > max_exr_side) {
    written.warnings.push_back(path + " is not written: a grid of " + std::to_string(columns) + " x " +
                               std::to_string(rows) + " exceeds the " + std::to_string(max_exr_side) +
                               " pixels a side that it can have; the table has all values");
    return;
  }
  attempt(written, path, [&](const std::string& file) {
    write_exr(file, columns, rows, {{"Y", illuminance.data(), 0, 0}, {"standard_error.Y", error.data(), 0, 0}},
              attributes);
  });
}

void write_meters(Written& written, const std::string& base, uint32_t index, const SensorEntry& meters,
                  const LoadedScene& scene, const ups_result* result, const MapStyle& map,
                  const Attributes& attributes) {
  const size_t count = meters.info.meter_count;
  MeterTable table;
  table.positions.resize(3 * count);
  table.normals.resize(3 * count);
  table.readings.resize(count);
  check(ups_gltf_read_meters(scene.import_result.get(), index, table.positions.data(), table.normals.data(), count),
        ups_gltf_last_error);
  check(ups_result_read_meters(result, meters.info.sensor, table.readings.data(), count));
  attempt(written, base + ".csv", [&](const std::string& path) { write_csv(path, table); });
  if (const auto sources = sources_of(scene, result); !sources.empty()) {
    const bool groups = sources[0].info.kind == UPS_SOURCE_GROUP;
    attempt(written, base + (groups ? "_groups.csv" : "_luminaires.csv"),
            [&](const std::string& path) { write_sources_csv(path, table.positions, meters, sources, result); });
  }
  if (meters.info.columns > 0) write_grid(written, base, meters, table, attributes);
  if (count > max_map_meters) {
    written.warnings.push_back(base + ": no map is drawn of more than " + std::to_string(max_map_meters) + " meters");
    return;
  }
  attempt(written, base, [&](const std::string& name) {
    if (const auto data = meter_map(meters, index, scene, result)) write_map(written, name, *data, map);
  });
}

void probe_folder(const std::string& option, const std::string& folder) {
  const extras::TemporaryFile probe(folder);
  if (!probe.descriptor.is_open())
    throw Failure(option + ": cannot write into the folder '" + folder + "': " + std::strerror(errno));
}

}  // namespace

std::vector<float> read_image(const ups_result* result, const SensorEntry& camera, ups_channel channel) {
  const bool one = channel == UPS_CHANNEL_ILLUMINANCE || channel == UPS_CHANNEL_ILLUMINANCE_STANDARD_ERROR ||
                   channel == UPS_CHANNEL_BIAS || channel == UPS_CHANNEL_ERROR_BOUND;
  const size_t channels = one ? 1 : 3;
  std::vector<float> pixels(size_t(camera.info.width) * camera.info.height * channels);
  check(ups_result_read_image(result, camera.info.sensor, channel, pixels.data(), 0, pixels.size() * sizeof(float)));
  return pixels;
}

void prepare_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw Failure("--out: cannot make the folder '" + folder + "'" + (error ? ": " + error.message() : ""));
  }
  probe_folder("--out", folder);
}

void prepare_file(const std::string& option, const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw Failure(option + ": '" + path + "' is a folder; it must be the name of a file");
  const extras::Destination to = extras::destination_of(path);
  if (!to.replaceable) return;
  const std::string folder = to.folder().string();
  if (!std::filesystem::is_directory(folder, error))
    throw Failure(option + ": cannot write '" + path + "': there is no folder '" + folder + "'; make it first");
  probe_folder(option, folder);
}

Written write_outputs(const std::string& folder, const LoadedScene& scene, const ups_result* result,
                      const MapStyle& map) {
  Written written;
  const Attributes attributes = common_attributes(result);
  for (uint32_t i = 0; i < scene.sensors.size(); ++i) {
    const SensorEntry& sensor = scene.sensors[i];
    if (sensor.info.kind == UPS_GLTF_OBSERVER) continue;  // its numbers are in the report
    attempt(written, (std::filesystem::path(folder) / sensor.name).string(), [&](const std::string& base) {
      if (sensor.info.kind == UPS_GLTF_CAMERA) {
        write_camera(written, base, sensor, result, map, attributes);
      } else if (sensor.info.kind == UPS_GLTF_GONIOMETER) {
        attempt(written, base + ".csv", [&](const std::string& path) { write_goniometer_csv(path, sensor, result); });
      } else {
        write_meters(written, base, i, sensor, scene, result, map, attributes);
      }
    });
  }
  return written;
}

}  // namespace ups::tool
