// See drawing_file.h.
#include "tool/drawing_file.h"

#include "common/atomic_file.h"
#include "tool/profile_file.h"

namespace ups::tool {

bool is_drawing_file(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".svg" || extension == ".png" || extension == ".pdf";
}

void write_drawing(const std::string& path, const Drawing& drawing, const Words& words) {
  constexpr double pixels_a_unit = 2;  // 192 an inch
  const std::string extension = lower_extension(path);
  const std::string bytes = extension == ".svg"   ? to_svg(drawing, words)
                            : extension == ".pdf" ? to_pdf(drawing, words)
                                                  : to_png(drawing, pixels_a_unit);
  extras::write_file(path, bytes.data(), bytes.size());
}

}  // namespace ups::tool
