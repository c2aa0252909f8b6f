// An OpenEXR file that is read channel by channel. Called by `ups compare` and `ups map`.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "tool/handles.h"

namespace ups::tool {

class ExrFile {
 public:
  explicit ExrFile(const std::string& path) {
    ups_exr_image* read = nullptr;
    check(ups_exr_read(path.c_str(), &read), ups_exr_last_error);
    image_.reset(read);
    check(ups_exr_get_size(read, &width_, &height_), ups_exr_last_error);
    uint32_t count = 0;
    check(ups_exr_get_channel_count(read, &count), ups_exr_last_error);
    for (uint32_t i = 0; i < count; ++i)
      names_.push_back(read_text([&](char* to, size_t capacity, size_t* needed) {
        return ups_exr_get_channel_name(read, i, to, capacity, needed);
      }));
  }

  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  size_t pixels() const { return size_t(width_) * height_; }
  std::string attribute(const char* name) const {  // a text; empty: there is none
    size_t needed = 0;
    if (ups_exr_get_attribute(image_.get(), name, nullptr, 0, &needed) != UPS_OK) return {};
    return read_text([&](char* to, size_t capacity, size_t* size) {
      return ups_exr_get_attribute(image_.get(), name, to, capacity, size);
    });
  }
  bool has(const std::string& name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }
  std::vector<float> channel(const std::string& name) const {
    std::vector<float> values(pixels());
    check(ups_exr_read_channel(image_.get(), name.c_str(), values.data(), values.size()), ups_exr_last_error);
    return values;
  }

 private:
  Image image_;
  uint32_t width_ = 0, height_ = 0;
  std::vector<std::string> names_;
};

}  // namespace ups::tool
