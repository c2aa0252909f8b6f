// See drawing_file.h.
#include "report/drawing_file.h"

#include "common/atomic_file.h"
#include "platform/paths.h"

namespace ups::report {

std::string lower_extension(const std::string& file) {
  std::string extension = platform::extension_of(file);
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  }
  return extension;
}

bool is_drawing_file(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".svg" || extension == ".png" || extension == ".pdf";
}

void write_drawing(const std::string& path, const Drawing& drawing, const Words& words, double zoom) {
  const std::string extension = lower_extension(path);
  const std::string bytes = extension == ".svg"   ? to_svg(drawing, words)
                            : extension == ".pdf" ? to_pdf(drawing, words)
                                                  : to_png(drawing, zoom);
  extras::write_file(path, bytes.data(), bytes.size());
}

}  // namespace ups::report
