// UPS extra for C++17: a glTF 2.0 file becomes the content of a scene, over ups_gltf.h, by the rules of ups.hpp. Link
// the library ups_gltf, and the core.
#ifndef UPS_GLTF_HPP
#define UPS_GLTF_HPP

#include "ups.hpp"
#include "ups_gltf.h"

namespace ups {
inline namespace v0_1 {
namespace detail {

struct DestroyGltf {
  void operator()(ups_gltf_import *p) const noexcept { ups_gltf_import_destroy(p); }
};
inline ups_status check_gltf(ups_status status) {
  if (status < 0) throw Error(status, ups_gltf_last_error());
  return status;
}

}  // namespace detail

struct GltfImportDesc : ups_gltf_import_desc {
  GltfImportDesc() noexcept { ups_gltf_import_desc_init(this, sizeof(ups_gltf_import_desc)); }
};

// 3 values a meter each: m; of length 1.
struct GltfMeters {
  std::vector<double> positions_m;
  std::vector<float> normals;
};

// What the file named; immutable, any thread.
class GltfImport : public Handle<ups_gltf_import, detail::DestroyGltf> {
 public:
  using Handle::Handle;
  // ups_gltf_import_file: adds all that is in the file, of a path in UTF-8, to the scene. Where it throws the scene
  // holds part of it.
  GltfImport(const Context &context, const std::string &path, Scene &scene, const GltfImportDesc &desc = {})
      : Handle(detail::value<ups_gltf_import *, detail::check_gltf>(ups_gltf_import_file, context.get(),
                                                                    detail::c_path(path), &desc, scene.get())) {}

  // In the order of the node hierarchy; the functions below take their index.
  std::vector<ups_gltf_sensor_info> sensors() const {
    std::vector<ups_gltf_sensor_info> out(
        detail::value<std::uint32_t, detail::check_gltf>(ups_gltf_get_sensor_count, get()));
    for (std::uint32_t i = 0; i < out.size(); ++i)
      out[i] = detail::sized<ups_gltf_sensor_info, detail::check_gltf>(ups_gltf_get_sensor, get(), i);
    return out;
  }
  std::string get_sensor_name(std::uint32_t index) const {
    return detail::text<detail::check_gltf>(ups_gltf_get_sensor_name, get(), index);
  }
  // Where the meters of a sensor are, or an observer's eye and where it looks.
  GltfMeters read_meters(std::uint32_t index) const {
    const auto info = detail::sized<ups_gltf_sensor_info, detail::check_gltf>(ups_gltf_get_sensor, get(), index);
    const std::size_t count = info.kind == UPS_GLTF_OBSERVER ? 1 : info.meter_count;
    GltfMeters out{std::vector<double>(3 * count), std::vector<float>(3 * count)};
    detail::check_gltf(ups_gltf_read_meters(get(), index, out.positions_m.data(), out.normals.data(), count));
    return out;
  }
  std::string get_source_name(ups_source_kind kind, std::uint32_t id) const {
    return detail::text<detail::check_gltf>(ups_gltf_get_source_name, get(), kind, id);
  }
  std::string get_source_file(ups_source_kind kind, std::uint32_t id) const {
    return detail::text<detail::check_gltf>(ups_gltf_get_source_file, get(), kind, id);
  }
  // Where in the file a part of the scene stands: 'node 7 "Tap"'.
  std::string get_place(ups_gltf_part part, std::uint32_t id) const {
    return detail::text<detail::check_gltf>(ups_gltf_get_place, get(), part, id);
  }
  std::string get_warnings() const { return detail::text<detail::check_gltf>(ups_gltf_get_warnings, get()); }
};

}  // namespace v0_1
}  // namespace ups

#endif
