// UPS extra for C++17: float images with named channels in OpenEXR files, over ups_exr.h, by the rules of ups.hpp. Link
// the library ups_exr, and the core, which names the statuses of errors.
#ifndef UPS_EXR_HPP
#define UPS_EXR_HPP

#include "hpp/base.hpp"
#include "ups_exr.h"

namespace ups {
inline namespace v0_1 {
namespace detail {

struct DestroyExr {
  void operator()(ups_exr_image *p) const noexcept { ups_exr_image_destroy(p); }
};
inline ups_status check_exr(ups_status status) {
  if (status < 0) throw Error(status, ups_exr_last_error());
  return status;
}

}  // namespace detail

// Paths are UTF-8. The file appears whole or not at all.
inline void exr_write(const std::string &path, std::uint32_t width, std::uint32_t height,
                      Span<const ups_exr_channel> channels, Span<const ups_exr_attribute> attributes = {}) {
  detail::check_exr(ups_exr_write(detail::c_path(path), width, height, channels.data(),
                                  detail::count(channels.size(), 1, "channels"), attributes.data(),
                                  detail::count(attributes.size(), 1, "attributes")));
}

// A file that was read, ups_exr_read; immutable, any thread.
class ExrImage : public Handle<ups_exr_image, detail::DestroyExr> {
 public:
  using Handle::Handle;
  explicit ExrImage(const std::string &path)
      : Handle(detail::value<ups_exr_image *, detail::check_exr>(ups_exr_read, detail::c_path(path))) {}

  std::uint32_t width() const { return size().first; }   // pixels
  std::uint32_t height() const { return size().second; }
  std::vector<std::string> channel_names() const {
    std::vector<std::string> out(detail::value<std::uint32_t, detail::check_exr>(ups_exr_get_channel_count, get()));
    for (std::uint32_t i = 0; i < out.size(); ++i)
      out[i] = detail::text<detail::check_exr>(ups_exr_get_channel_name, get(), i);
    return out;
  }
  std::string get_attribute(const char *name) const {
    return detail::text<detail::check_exr>(ups_exr_get_attribute, get(), name);
  }
  // width() * height() values, row 0 is the top.
  std::vector<float> read_channel(const char *name) const {
    std::vector<float> out(std::size_t{width()} * height());
    detail::check_exr(ups_exr_read_channel(get(), name, out.data(), out.size()));
    return out;
  }

 private:
  std::pair<std::uint32_t, std::uint32_t> size() const {
    std::pair<std::uint32_t, std::uint32_t> out;
    detail::check_exr(ups_exr_get_size(get(), &out.first, &out.second));
    return out;
  }
};

}  // namespace v0_1
}  // namespace ups

#endif
