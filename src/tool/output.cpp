// See output.h: a camera's images and the layers of its techniques; a meter set's table, a grid's also as images;
// folders and files tried out before a render.
#include "tool/output.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "common/atomic_file.h"
#include "platform/paths.h"
#include "tool/csv.h"
#include "report/drawing_file.h"
#include "report/map_data.h"
#include "report/meter_places.h"
#include "tool/inputs.h"
#include "tool/picture.h"
#include "tool/report.h"
#include "tool/tables.h"
#include "tool/text_format.h"

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
  const Words words = map_words(data, style);
  const Drawing drawing = map_drawing(data, style);
  for (const char* ending : {".png", ".svg", ".pdf"})
    attempt(written, base + ending, [&](const std::string& path) { write_drawing(path, drawing, words); });
}

// What the file asks for of what a camera sees first.
struct LayerPlane {
  const char* channels[4];
  size_t components;
  const char* unit;
  std::vector<float> values;
};
std::vector<LayerPlane> layer_planes(const SensorEntry& camera, const ups_result* result) {
  std::vector<LayerPlane> planes;
  const auto add = [&](uint32_t layer, ups_channel channel, LayerPlane plane) {
    if (!(camera.info.layers & layer)) return;
    plane.values = read_image(result, camera, channel);
    planes.push_back(std::move(plane));
  };
  add(UPS_LAYER_ALBEDO, UPS_CHANNEL_ALBEDO_RGB, {{"albedo.R", "albedo.G", "albedo.B", nullptr}, 3, nullptr, {}});
  add(UPS_LAYER_NORMAL, UPS_CHANNEL_NORMAL, {{"normal.X", "normal.Y", "normal.Z", nullptr}, 3, nullptr, {}});
  add(UPS_LAYER_DEPTH, UPS_CHANNEL_DEPTH, {{"depth.Z", nullptr}, 1, "m", {}});
  add(UPS_LAYER_ID, UPS_CHANNEL_ID, {{"id.Y", nullptr}, 1, nullptr, {}});
  return planes;
}

std::vector<std::pair<const char*, std::vector<float>>> illuminance_planes(const SensorEntry& camera,
                                                                           const ups_result* result) {
  if (!camera.info.illuminance) return {};
  const auto read = [&](ups_channel channel) { return read_image(result, camera, channel); };
  return {{"illuminance.Y", read(UPS_CHANNEL_ILLUMINANCE)},
          {"standard_error.illuminance.Y", read(UPS_CHANNEL_ILLUMINANCE_STANDARD_ERROR)},
          {"bias.illuminance.Y", read(UPS_CHANNEL_ILLUMINANCE_BIAS)},
          {"error_bound.illuminance.Y", read(UPS_CHANNEL_ILLUMINANCE_ERROR_BOUND)}};
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
  const std::vector<std::pair<const char*, std::vector<float>>> illuminance = illuminance_planes(camera, result);
  for (const auto& [name, values] : illuminance) {
    channels.push_back({name, values.data(), 0, 0});
    attributes.emplace_back(std::string("unit.") + name, "lx");
  }
  if (camera.info.projection != UPS_PERSPECTIVE)
    attributes.emplace_back("projection", projection_word(camera.info.projection));
  const std::vector<LayerPlane> layers = layer_planes(camera, result);
  for (const LayerPlane& layer : layers) {
    for (size_t k = 0; layer.channels[k]; ++k)
      channels.push_back({layer.channels[k], &layer.values[k], layer.components * sizeof(float), 0});
    if (layer.unit) attributes.emplace_back(std::string("unit.") + layer.channels[0], layer.unit);
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
                  const MapStyle& map, const PictureOptions& picture, const Attributes& attributes) {
  const uint32_t width = camera.info.width, height = camera.info.height;
  attempt(written, base + ".exr", [&](const std::string& path) { write_camera_exr(path, camera, result, attributes); });
  attempt(written, base + ".png", [&](const std::string& path) { write_picture(path, camera, result, picture); });
  attempt(written, base + "_techniques.exr",
          [&](const std::string& path) { write_techniques(path, camera, result, attributes); });
  attempt(written, base + "_luminance", [&](const std::string& name) {
    const auto luminance =
        within_image(camera.info, luminance_of(read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB)));
    const auto bound = read_image(result, camera, UPS_CHANNEL_ERROR_BOUND);
    write_map(written, name, image_map(camera.name, "Luminance", "cd/m\u00b2", luminance, bound, width, height),
              of_luminance(map));
  });
  if (!camera.info.illuminance) return;
  attempt(written, base + "_illuminance", [&](const std::string& name) {
    const auto illuminance = within_image(camera.info, read_image(result, camera, UPS_CHANNEL_ILLUMINANCE));
    const auto bound = read_image(result, camera, UPS_CHANNEL_ILLUMINANCE_ERROR_BOUND);
    write_map(written, name, image_map(camera.name, "Illuminance", "lx", illuminance, bound, width, height), map);
  });
}

struct MeterTable {
  MeterPlaces places;
  std::vector<ups_meter_reading> readings;
  std::array<std::vector<ups_vector_part_reading>, 3> vectors{};  // of such meters, by ups_light_part
};

MeterTable read_table(const SensorEntry& meters, const LoadedScene& scene, const ups_result* result) {
  const size_t count = meters.info.meter_count;
  MeterTable table{meter_places(scene, meters), std::vector<ups_meter_reading>(count)};
  check(ups_result_read_meters(result, meters.info.sensor, table.readings.data(), count));
  if (meters.info.meter_kind != UPS_METER_VECTOR) return table;
  for (size_t part = 0; part < table.vectors.size(); ++part) {
    table.vectors[part].resize(count);
    check(ups_result_read_vector_part(result, meters.info.sensor, ups_light_part(part), table.vectors[part].data(),
                                      count));
  }
  return table;
}

struct Plane {
  const char *name, *unit;
};

// What tables, grids and lightmaps have of a reading, in the order of values_of.
constexpr Plane reading_planes[] = {{"Y", "lx"},           {"standard_error.Y", "lx"}, {"bias.Y", "lx"},
                                    {"error_bound.Y", "lx"}, {"direct.Y", "lx"},         {"indirect.Y", "lx"}};
std::array<float, std::size(reading_planes)> values_of(const ups_meter_reading& r) {
  return {r.illuminance_lx, r.standard_error_lx, r.bias_lx, r.error_bound_lx, r.direct_lx, r.indirect_lx};
}

// values: of every plane for each pixel in turn.
void write_planes(const std::string& path, uint32_t width, uint32_t height, const std::vector<Plane>& planes,
                  const std::vector<float>& values, Attributes attributes) {
  std::vector<ups_exr_channel> channels;
  for (size_t k = 0; k < planes.size(); ++k) {
    channels.push_back({planes[k].name, &values[k], planes.size() * sizeof(float), 0});
    attributes.emplace_back(std::string("unit.") + planes[k].name, planes[k].unit);
  }
  write_exr(path, width, height, channels, attributes);
}

// map_width: of a lightmap, else 0.
void write_csv(const std::string& path, const MeterTable& table, uint32_t map_width) {
  std::string header =
      "x_m,y_m,z_m,nx,ny,nz,illuminance_lx,standard_error_lx,bias_lx,error_bound_lx,direct_lx,indirect_lx";
  const auto& vectors = table.vectors[UPS_LIGHT_PART_ALL];
  if (!vectors.empty())
    for (const char* what : {"", "_standard_error", "_bias", "_error_bound", "_direct", "_indirect"})
      for (const char axis : {'x', 'y', 'z'}) header += std::string(",vector_") + axis + what + "_lx";
  const std::vector<ups_meter_place>& surfaces = table.places.surfaces;
  if (!surfaces.empty()) header += ",triangle,area_m2";
  if (map_width > 0) header += ",column,row";
  Csv csv(header);
  for (const size_t i : table.places.listed) {
    for (size_t k = 3 * i; k < 3 * i + 3; ++k) csv.add_place(table.places.positions[k]);
    for (size_t k = 3 * i; k < 3 * i + 3; ++k) csv.add(double(table.places.normals[k]));
    for (const float value : values_of(table.readings[i])) csv.add(double(value));
    if (!vectors.empty()) {
      const ups_vector_part_reading& v = vectors[i];
      for (const float* part : {v.vector_lx, v.standard_error_lx, v.bias_lx, v.error_bound_lx,
                                table.vectors[UPS_LIGHT_PART_DIRECT][i].vector_lx,
                                table.vectors[UPS_LIGHT_PART_INDIRECT][i].vector_lx})
        for (int k = 0; k < 3; ++k) csv.add(double(part[k]));
    }
    if (!surfaces.empty()) {
      csv.add(double(surfaces[i].triangle));
      csv.add(double(surfaces[i].area_m2));
    }
    if (map_width > 0) {
      csv.add(double(i % map_width));
      csv.add(double(i / map_width));
    }
    csv.end_row();
  }
  csv.write(path);
}

// Row 0, at v = 0, is the image's top line.
void write_lightmap(const std::string& path, const SensorEntry& map, const MeterTable& table,
                    const Attributes& attributes) {
  std::vector<Plane> planes(std::begin(reading_planes), std::end(reading_planes));
  planes.insert(planes.end(), {{"position.X", "m"}, {"position.Y", "m"}, {"position.Z", "m"}, {"area", "m^2"},
                               {"valid", "1: in use, 0: empty"}});
  std::vector<float> texels;
  texels.reserve(planes.size() * table.readings.size());
  for (size_t i = 0; i < table.readings.size(); ++i) {
    const auto reading = values_of(table.readings[i]);
    const ups_meter_place& p = table.places.surfaces[i];
    texels.insert(texels.end(), reading.begin(), reading.end());
    texels.insert(texels.end(), {float(p.position_m[0]), float(p.position_m[1]), float(p.position_m[2]), p.area_m2,
                                 float(p.valid)});
  }
  write_planes(path, map.info.width, map.info.height, planes, texels, attributes);
}

// An image's top line is the grid's last row: row 0 stands at the bottom.
void write_grid(Written& written, const std::string& base, const SensorEntry& grid, const MeterTable& table,
                const Attributes& attributes) {
  const uint32_t columns = grid.info.columns, rows = grid.info.rows;
  const std::string path = base + ".exr";
  if (std::max(columns, rows) > max_exr_side) {
    written.warnings.push_back(path + " is not written: a grid of " + std::to_string(columns) + " x " +
                               std::to_string(rows) + " exceeds the " + std::to_string(max_exr_side) +
                               " pixels a side that it can have; the table has all values");
    return;
  }
  std::vector<float> cells;
  cells.reserve(std::size(reading_planes) * table.readings.size());
  for (uint32_t row = rows; row-- > 0;) {
    for (uint32_t column = 0; column < columns; ++column) {
      const auto reading = values_of(table.readings[size_t(row) * columns + column]);
      cells.insert(cells.end(), reading.begin(), reading.end());
    }
  }
  attempt(written, path, [&](const std::string& file) {
    write_planes(file, columns, rows, {std::begin(reading_planes), std::end(reading_planes)}, cells, attributes);
  });
}

void write_meters(Written& written, const std::string& base, const SensorEntry& meters,
                  const LoadedScene& scene, const ups_result* result, const MapStyle& map,
                  const Attributes& attributes) {
  const MeterTable table = read_table(meters, scene, result);
  const bool lightmap = meters.info.layout == MeterLayout::lightmap;
  attempt(written, base + ".csv",
          [&](const std::string& path) { write_csv(path, table, lightmap ? meters.info.width : 0); });
  if (lightmap)
    attempt(written, base + ".exr",
            [&](const std::string& path) { write_lightmap(path, meters, table, attributes); });
  if (const auto sources = sources_of(scene, result); !sources.empty()) {
    const bool groups = sources[0].info.kind == UPS_SOURCE_GROUP;
    attempt(written, base + (groups ? "_groups.csv" : "_luminaires.csv"),
            [&](const std::string& path) { write_sources_csv(path, table.places.positions, table.places.listed, meters, sources, result); });
  }
  if (meters.info.columns > 0) write_grid(written, base, meters, table, attributes);
  if (meters.info.meter_count > max_map_meters) {
    written.warnings.push_back(base + ": no map is drawn of more than " + std::to_string(max_map_meters) + " meters");
    return;
  }
  attempt(written, base, [&](const std::string& name) {
    if (const auto data = meter_map(meters, scene, result)) write_map(written, name, *data, map);
  });
}

void probe_folder(const std::string& option, const std::string& folder) {
  if (const std::error_code error = platform::try_folder(folder))
    throw Failure(option + ": cannot write into the folder '" + folder + "': " + platform::message_of(error));
}

// What follows its name in the files that write_outputs() writes of a sensor.
std::vector<std::string> endings_of(const SensorEntry& sensor, const ups_render_desc& desc) {
  using Endings = std::vector<std::string>;
  const auto map = [](const std::string& base) { return Endings{base + ".png", base + ".svg", base + ".pdf"}; };
  Endings endings;
  const auto add = [&](const Endings& more) { endings.insert(endings.end(), more.begin(), more.end()); };
  if (sensor.info.kind == SensorKind::goniometer) return {".csv"};
  if (sensor.info.kind == SensorKind::camera) {
    add({".exr", ".png"});
    add(map("_luminance"));
    if (sensor.info.illuminance) add(map("_illuminance"));
    if (desc.technique_images > 0) add({"_techniques.exr"});
  } else if (sensor.info.kind == SensorKind::meters) {
    add({".csv"});
    add(map(""));
    if (sensor.info.columns > 0 || sensor.info.layout == MeterLayout::lightmap) add({".exr"});
    if (desc.separation != UPS_SEPARATE_NOTHING)
      add({desc.separation == UPS_SEPARATE_GROUPS ? "_groups.csv" : "_luminaires.csv"});
  }
  return endings;
}

}  // namespace

void prepare_folder(const std::string& folder) {
  const std::error_code error = platform::make_folder(folder);
  if (error || !platform::is_folder(folder)) {
    const std::string why = error ? ": " + platform::message_of(error) : "";
    throw Failure("--out: cannot make the folder '" + folder + "'" + why);
  }
  probe_folder("--out", folder);
}

void prepare_file(const std::string& option, const std::string& path) {
  if (platform::is_folder(path))
    throw Failure(option + ": '" + path + "' is a folder; it must be the name of a file");
  const std::optional<std::string> folder = platform::folder_written_in(path);
  if (!folder) return;
  if (!platform::is_folder(*folder))
    throw Failure(option + ": cannot write '" + path + "': there is no folder '" + *folder + "'; make it first");
  probe_folder(option, *folder);
}

void prepare_files(const RenderOptions& options, const LoadedScene& scene) {
  std::vector<std::string> names;
  for (const SensorEntry& sensor : scene.sensors)
    for (const std::string& ending : endings_of(sensor, options.desc)) names.push_back(sensor.name + ending);
  if (options.report) names.push_back("report.html");
  std::vector<Output> outputs;
  for (const std::string& name : names) {
    const std::string path = platform::joined(options.out, name);
    if (platform::is_folder(path))
      throw Failure("--out: '" + path + "' is a folder, where a file of that name would be written");
    platform::folder_written_in(path);  // throws where it may not be
    outputs.emplace_back("--out", path);
  }
  spare_inputs(options.scene, outputs);
  std::sort(names.begin(), names.end());
  if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
    throw Failure("--out: two of the scene's cameras, meters and goniometers would write the file '" + *twice +
                  "'; give one of them another name");
}

Written write_outputs(const std::string& folder, const LoadedScene& scene, const ups_result* result,
                      const MapStyle& map, const PictureOptions& picture) {
  Written written;
  const Attributes attributes = common_attributes(result);
  for (const SensorEntry& sensor : scene.sensors) {
    if (sensor.info.kind == SensorKind::observer) continue;  // its numbers are in the report
    attempt(written, platform::joined(folder, sensor.name), [&](const std::string& base) {
      if (sensor.info.kind == SensorKind::camera) {
        write_camera(written, base, sensor, result, map, picture, attributes);
      } else if (sensor.info.kind == SensorKind::goniometer) {
        attempt(written, base + ".csv", [&](const std::string& path) { write_goniometer_csv(path, sensor, result); });
      } else {
        write_meters(written, base, sensor, scene, result, map, attributes);
      }
    });
  }
  return written;
}

}  // namespace ups::tool
