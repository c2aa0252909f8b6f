// ups info: what a scene file contains and calls for, or what a photometric file says.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tool/commands.h"
#include "tool/handles.h"

namespace ups::tool {

namespace {

std::string lower_extension(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  }
  return extension;
}

std::string read_bytes(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw Failure("cannot open '" + file + "'");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string opening_text(const ups_profile_info& info) {
  char text[128];
  const float* m = info.opening_m;
  switch (info.opening_shape) {
    case UPS_OPENING_RECTANGLE:
      std::snprintf(text, sizeof text, "rectangle %g x %g m", m[0], m[1]);
      break;
    case UPS_OPENING_DISC:
      std::snprintf(text, sizeof text, "disc %g x %g m", m[0], m[1]);
      break;
    case UPS_OPENING_BOX:
      std::snprintf(text, sizeof text, "box %g x %g x %g m", m[0], m[1], m[2]);
      break;
    case UPS_OPENING_CYLINDER:
      std::snprintf(text, sizeof text, "cylinder %g x %g x %g m", m[0], m[1], m[2]);
      break;
    case UPS_OPENING_SPHERE:
      std::snprintf(text, sizeof text, "sphere %g x %g x %g m", m[0], m[1], m[2]);
      break;
    default:
      return "point";
  }
  return text;
}

const char* symmetry_text(ups_profile_symmetry symmetry) {
  switch (symmetry) {
    case UPS_SYMMETRY_AXIAL:
      return "axial";
    case UPS_SYMMETRY_C0_C180:
      return "about the plane C0-C180";
    case UPS_SYMMETRY_C90_C270:
      return "about the plane C90-C270";
    case UPS_SYMMETRY_QUADRANTS:
      return "about both planes, C0-C180 and C90-C270";
    default:
      return "none";
  }
}

void print_list(const char* title, const std::string& text) {
  const auto lines = lines_of(text);
  std::printf("%s:%s\n", title, lines.empty() ? " none" : "");
  for (const std::string& line : lines) std::printf("  %s\n", line.c_str());
}

void print_profile(const std::string& file, const ups_profile* profile) {
  ups_profile_info info{};
  info.struct_size = sizeof info;
  check(ups_profile_get_info(profile, &info));
  const auto text = [&](ups_profile_text topic) {
    return read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_profile_get_text(profile, topic, to, capacity, needed);
    });
  };
  std::printf("%s\n", file.c_str());
  std::printf("format: %s\n", text(UPS_PROFILE_TEXT_FORMAT).c_str());
  std::printf("flux: %.6g lm (as interpolated for rendering: %.6g lm)\n", info.flux_lm, info.interpolated_flux_lm);
  if (info.rated_flux_lm >= 0) {
    std::printf("rated lamp flux: %.6g lm\n", info.rated_flux_lm);
  } else {
    std::printf("rated lamp flux: none, absolute photometry\n");
  }
  if (info.input_power_w >= 0) std::printf("input power: %g W\n", info.input_power_w);
  std::printf("peak: %.6g cd at C %g deg, gamma %g deg\n", info.peak_cd, info.peak_c_deg, info.peak_gamma_deg);
  std::printf("symmetry: %s\n", symmetry_text(info.symmetry));
  std::printf("opening: %s\n", opening_text(info).c_str());
  std::printf("table: %u C-planes x %u gamma angles\n", info.c_count, info.gamma_count);
  print_list("keywords", text(UPS_PROFILE_TEXT_KEYWORDS));
  print_list("warnings", text(UPS_PROFILE_TEXT_WARNINGS));
}

void print_sensor(const SensorEntry& sensor) {
  const ups_gltf_sensor_info& info = sensor.info;
  if (info.kind == UPS_GLTF_CAMERA) {
    std::printf("  camera %s: %u x %u%s\n", sensor.name.c_str(), info.width, info.height,
                info.illuminance ? ", illuminance too" : "");
  } else if (info.kind == UPS_GLTF_GONIOMETER) {
    std::printf("  goniometer %s: %u planes of %u angles\n", sensor.name.c_str(), info.columns, info.rows);
  } else if (info.columns > 0) {
    std::printf("  meters %s: grid of %u x %u\n", sensor.name.c_str(), info.columns, info.rows);
  } else {
    std::printf("  meters %s: %u points\n", sensor.name.c_str(), info.meter_count);
  }
}

void print_scene(const std::string& file, const LoadedScene& scene) {
  ups_scene_info info{};
  info.struct_size = sizeof info;
  check(ups_scene_get_info(scene.scene.get(), &info));
  const auto text = [&](ups_scene_text topic) {
    return read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_scene_get_text(scene.scene.get(), topic, to, capacity, needed);
    });
  };
  const auto count = [](uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf("%s\n", file.c_str());
  std::printf("triangles: %llu\n", count(info.triangle_count));
  if (info.bounds_min_m[0] <= info.bounds_max_m[0]) {
    std::printf("bounds: (%g, %g, %g) to (%g, %g, %g) m\n", info.bounds_min_m[0], info.bounds_min_m[1],
                info.bounds_min_m[2], info.bounds_max_m[0], info.bounds_max_m[1], info.bounds_max_m[2]);
  }
  std::printf("emitters: %llu luminaires, %llu lights, %llu emitting instances, together %.6g lm\n",
              count(info.luminaire_count), count(info.light_count), count(info.emissive_instance_count),
              info.emitted_flux_lm);
  std::printf("sensors: %llu meters, %llu pixels\n", count(info.meter_count), count(info.pixel_count));
  for (const SensorEntry& sensor : scene.sensors) print_sensor(sensor);
  print_list("effects", text(UPS_SCENE_TEXT_EFFECTS));
  print_list("techniques", text(UPS_SCENE_TEXT_TECHNIQUES));
  std::printf("warnings:%s\n", scene.warnings.empty() ? " none" : "");
  for (const std::string& warning : scene.warnings) std::printf("  %s\n", warning.c_str());
}

}  // namespace

int info(const std::string& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".ies" || extension == ".ldt") {
    const Context context = make_context(1);
    const std::string bytes = read_bytes(file);
    const ups_profile_format format = extension == ".ies" ? UPS_PROFILE_IES_LM63 : UPS_PROFILE_EULUMDAT;
    ups_profile* parsed = nullptr;
    if (ups_profile_parse(context.get(), bytes.data(), bytes.size(), format, &parsed) != UPS_OK) {
      throw Failure(file + ": " + without_functions(ups_last_error()));
    }
    print_profile(file, Profile(parsed).get());
  } else if (extension == ".gltf" || extension == ".glb") {
    print_scene(file, load_scene(file, 0, 0, 0));
  } else {
    throw Failure(file + ": not a kind of file that is known here: .gltf, .glb, .ies or .ldt");
  }
  return exit_done;
}

}  // namespace ups::tool
