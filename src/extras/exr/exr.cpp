// OpenEXR files of float channels: written for renders and grids, read for `ups compare`. The only file that includes
// OpenEXR. Files are composed in memory first: OpenEXR's writer reports no error of its last bytes.
#include "ups/ups_exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "base/owner.h"
#include "common/atomic_file.h"
#include "common/boundary.h"
#include "platform/paths.h"

struct ups_exr_image {
  ups::Owner<ups_exr_image> owner;
  uint32_t width = 0, height = 0;
  std::vector<std::string> names;
  std::vector<std::vector<float>> channels;
  std::vector<std::pair<std::string, std::string>> attributes;
};

namespace {

using ups::extras::Error;
using ups::extras::require;

// A small file can claim a large image: beyond 1 GiB it must have a byte for so many of the image's. Deflated zeros,
// of which cameras may have 16384 x 16384 in each channel, take one for 1032.
constexpr uint64_t believed_bytes = uint64_t(1) << 30, most_inflated = 4096;
constexpr int64_t max_side = 65536;
constexpr uint32_t max_channels = 4096;  // images of techniques have up to 1638

// OpenEXR's own attributes of other types than text, and one that it writes itself.
constexpr const char* reserved[] = {
    "adoptedNeutral", "altitude", "aperture", "chromaticities", "chunkCount", "deepImageState", "dwaCompressionLevel",
    "envmap", "expTime", "focus", "framesPerSecond", "idManifest", "isoSpeed", "keyCode", "latitude", "longitude",
    "maxSamplesPerPixel", "multiView", "originalDataWindow", "preview", "tiles", "timeCode", "type", "utcOffset",
    "version", "whiteLuminance", "worldToCamera", "worldToNDC", "xDensity"};

ups::LastError last_error;

template <class Body>
ups_status guarded(Body&& body) {
  return ups::extras::guarded(last_error, body);
}

class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}
  void write(const char c[], int n) override {
    if (bytes_.size() < position_ + size_t(n)) bytes_.resize(position_ + size_t(n));
    std::memcpy(bytes_.data() + position_, c, size_t(n));
    position_ += size_t(n);
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = size_t(position); }
  const std::vector<char>& bytes() const { return bytes_; }

 private:
  std::vector<char> bytes_;
  size_t position_ = 0;
};

constexpr size_t longest_name = 255;  // OpenEXR would cut what is longer

void check_channels(const ups_exr_channel* channels, uint32_t count) {
  require(channels != nullptr && count > 0, "no channels are given");
  require(count <= max_channels, "channel_count must be at most 4096");
  for (uint32_t i = 0; i < count; ++i) {
    require(channels[i].name != nullptr && channels[i].name[0] != '\0', "a channel has no name");
    require(std::strlen(channels[i].name) <= longest_name, "a channel's name has more than 255 bytes");
    require(channels[i].data != nullptr, "a channel's data is NULL");
    for (uint32_t j = 0; j < i; ++j) {
      require(std::strcmp(channels[i].name, channels[j].name) != 0, "two channels have the same name");
    }
  }
}

bool is_reserved(const char* name) {
  return std::any_of(std::begin(reserved), std::end(reserved),
                     [&](const char* own) { return std::strcmp(own, name) == 0; });
}

Imf::Header make_header(uint32_t width, uint32_t height, const ups_exr_channel* channels, uint32_t channel_count,
                        const ups_exr_attribute* attributes, uint32_t attribute_count) {
  Imf::Header header{int(width), int(height)};
  header.compression() = Imf::ZIP_COMPRESSION;
  for (uint32_t i = 0; i < channel_count; ++i) header.channels().insert(channels[i].name, Imf::Channel(Imf::FLOAT));
  require(attributes != nullptr || attribute_count == 0, "attributes is NULL");
  for (uint32_t i = 0; i < attribute_count; ++i) {
    require(attributes[i].name != nullptr && attributes[i].name[0] != '\0', "an attribute has no name");
    require(std::strlen(attributes[i].name) <= longest_name, "an attribute's name has more than 255 bytes");
    require(attributes[i].value != nullptr, "an attribute's value is NULL");
    const std::string named = std::string("the attribute '") + attributes[i].name + "'";
    if (is_reserved(attributes[i].name)) throw Error(UPS_ERROR_INVALID_ARGUMENT, named + " is OpenEXR's own");
    if (header.find(attributes[i].name) != header.end())
      throw Error(UPS_ERROR_INVALID_ARGUMENT, named + " is OpenEXR's own or given twice");
    header.insert(attributes[i].name, Imf::StringAttribute(attributes[i].value));
  }
  return header;
}

std::vector<char> compose(const Imf::Header& header, uint32_t width, uint32_t height, const ups_exr_channel* channels,
                          uint32_t channel_count) {
  ups::extras::ask_for_memory(ups::extras::ample_bytes + size_t(width) * height * channel_count * 4 * sizeof(float));
  MemoryStream stream;
  {
    Imf::OutputFile file(stream, header);
    Imf::FrameBuffer frame;
    for (uint32_t i = 0; i < channel_count; ++i) {
      const ups_exr_channel& channel = channels[i];
      const size_t pixel = channel.pixel_stride_bytes ? channel.pixel_stride_bytes : sizeof(float);
      const size_t row = channel.row_stride_bytes ? channel.row_stride_bytes : pixel * width;
      // OpenEXR's slices serve reading too, hence the cast; writing only reads.
      char* data = reinterpret_cast<char*>(const_cast<float*>(channel.data));
      frame.insert(channel.name, Imf::Slice(Imf::FLOAT, data, pixel, row));
    }
    file.setFrameBuffer(frame);
    file.writePixels(int(height));
  }
  return stream.bytes();
}

// Luminance/chroma images have channels with fewer samples, too: they have no place among pixels.
std::vector<std::string> full_channels_of(const Imf::Header& header) {
  std::vector<std::string> names;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
    if (it.channel().xSampling == 1 && it.channel().ySampling == 1) names.emplace_back(it.name());
  return names;
}

void read_image(const char* path, uint64_t file_bytes, ups_exr_image& image) {
  Imf::InputFile file(path);
  const Imf::Header& header = file.header();
  const auto window = header.dataWindow();
  auto whole = header.displayWindow();  // a cropped file holds less of it: images of one camera stay comparable
  whole.extendBy(window);
  const int64_t width = int64_t(whole.max.x) - whole.min.x + 1, height = int64_t(whole.max.y) - whole.min.y + 1;
  image.names = full_channels_of(header);
  const uint64_t count = image.names.size();
  if (count == 0) throw Error(UPS_ERROR_UNSUPPORTED, "no channel has a value for each pixel");
  const std::string claimed = "an image of " + std::to_string(width) + " x " + std::to_string(height) + " pixels and " +
                              std::to_string(count) + " channels";
  if (width < 1 || height < 1 || width > max_side || height > max_side || count > max_channels)
    throw Error(UPS_ERROR_UNSUPPORTED, claimed + " is not read; at most 65536 x 65536 and 4096 are");
  const uint64_t bytes = uint64_t(width) * uint64_t(height) * count * sizeof(float);
  if (bytes > believed_bytes && bytes / most_inflated > file_bytes)
    throw Error(UPS_ERROR_PARSE, claimed + " is not in a file of " + std::to_string(file_bytes) + " bytes");
  ups::extras::ask_for_memory(ups::extras::ample_bytes + size_t(2 * bytes));
  image.width = uint32_t(width);
  image.height = uint32_t(height);
  Imf::FrameBuffer frame;
  image.channels.assign(count, std::vector<float>(size_t(width * height)));
  for (size_t i = 0; i < count; ++i)
    frame.insert(image.names[i], Imf::Slice::Make(Imf::FLOAT, image.channels[i].data(), whole));
  for (auto it = header.begin(); it != header.end(); ++it) {
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute());
    if (text) image.attributes.emplace_back(it.name(), text->value());
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
}

}  // namespace

ups_status ups_exr_write(const char* path, uint32_t width, uint32_t height, const ups_exr_channel* channels,
                         uint32_t channel_count, const ups_exr_attribute* attributes, uint32_t attribute_count) {
  return guarded([&] {
    require(path != nullptr, "path is NULL");
    check_channels(channels, channel_count);
    require(width > 0 && height > 0 && width <= max_side && height <= max_side, "width and height must be 1 to 65536");
    const Imf::Header header = make_header(width, height, channels, channel_count, attributes, attribute_count);
    const std::vector<char> bytes = compose(header, width, height, channels, channel_count);
    ups::extras::write_file(path, bytes.data(), bytes.size());
  });
}

ups_status ups_exr_read(const char* path, ups_exr_image** out) {
  return guarded([&] {
    require(path != nullptr, "path is NULL");
    require(out != nullptr, "out is NULL");
    errno = 0;
    auto file = ups::platform::open_to_read(path);
    if (!file && errno == ENOMEM) throw std::bad_alloc();
    if (!file)
      throw Error(UPS_ERROR_IO, std::string("cannot open '") + path + "': " + ups::platform::why_not_open(path));
    if (file.peek(); file.bad()) throw Error(UPS_ERROR_IO, std::string("cannot read '") + path + "': no file?");
    if (!file.seekg(0, std::ios::end))
      throw Error(UPS_ERROR_IO, std::string("cannot read '") + path + "': it is a pipe; images are read from files");
    const auto file_bytes = uint64_t(file.tellg());
    auto image = std::make_unique<ups_exr_image>();
    try {
      read_image(path, file_bytes, *image);
    } catch (const Error& e) {
      throw Error(e.status(), std::string("'") + path + "': " + e.what());
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& e) {  // OpenEXR's own
      if (ups::extras::tells_of_memory(e)) throw std::bad_alloc();
      throw Error(UPS_ERROR_PARSE, std::string("'") + path + "' is not a readable OpenEXR image: " + e.what());
    }
    *out = image.release();
  });
}

void ups_exr_image_destroy(ups_exr_image* image) { ups::destroy(image); }

ups_status ups_exr_get_size(const ups_exr_image* image, uint32_t* width, uint32_t* height) {
  return guarded([&] {
    ups::extras::require_handle(image, "image");
    require(width != nullptr && height != nullptr, "width or height is NULL");
    *width = image->width;
    *height = image->height;
  });
}

ups_status ups_exr_get_channel_count(const ups_exr_image* image, uint32_t* out) {
  return guarded([&] {
    ups::extras::require_handle(image, "image");
    require(out != nullptr, "out is NULL");
    *out = uint32_t(image->names.size());
  });
}

ups_status ups_exr_get_channel_name(const ups_exr_image* image, uint32_t index, char* text, size_t capacity,
                                    size_t* needed) {
  return guarded([&] {
    ups::extras::require_handle(image, "image");
    require(index < image->names.size(), "index is not below the channel count");
    ups::extras::copy_text(image->names[index], text, capacity, needed);
  });
}

ups_status ups_exr_get_attribute(const ups_exr_image* image, const char* name, char* text, size_t capacity,
                                 size_t* needed) {
  return guarded([&] {
    ups::extras::require_handle(image, "image");
    require(name != nullptr, "name is NULL");
    for (const auto& [key, value] : image->attributes) {
      if (key == name) return ups::extras::copy_text(value, text, capacity, needed);
    }
    throw Error(UPS_ERROR_INVALID_ARGUMENT, std::string("there is no text attribute '") + name + "'");
  });
}

ups_status ups_exr_read_channel(const ups_exr_image* image, const char* name, float* out, size_t count) {
  return guarded([&] {
    ups::extras::require_handle(image, "image");
    require(name != nullptr, "name is NULL");
    require(out != nullptr, "out is NULL");
    std::string all;
    for (size_t i = 0; i < image->names.size(); ++i) {
      all += (i ? ", " : "") + image->names[i];
      if (image->names[i] != name) continue;
      require(count == image->channels[i].size(), "count is not width * height");
      std::copy(image->channels[i].begin(), image->channels[i].end(), out);
      return;
    }
    throw Error(UPS_ERROR_INVALID_ARGUMENT, std::string("there is no channel '") + name + "', only " + all);
  });
}

const char* ups_exr_last_error(void) { return last_error.get(); }
