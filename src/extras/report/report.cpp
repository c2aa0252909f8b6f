// The C boundary of ups_report.
#include "ups/ups_report.h"

#include "common/atomic_file.h"
#include "common/boundary.h"
#include "platform/numbers.h"
#include "report/descs.h"
#include "report/drawing_file.h"

namespace {

using ups::extras::require;

ups::LastError last_error;

template <class Body>
ups_status guarded(Body&& body) {
  return ups::extras::guarded(last_error, [&] {
    const ups::platform::PointInNumbers point;
    body();
  });
}

// Before a long page or map is made for nothing.
void check_path(const char* path) {
  require(path != nullptr, "path is NULL");
  require(path[0] != '\0', "path is empty");
}

}  // namespace

void ups_report_style_desc_init(ups_report_style_desc* desc, uint32_t struct_size) {
  ups::extras::write_defaults(desc, struct_size, ups::report::style_defaults());
}

void ups_report_map_desc_init(ups_report_map_desc* desc, uint32_t struct_size) {
  ups::extras::write_defaults(desc, struct_size, ups::report::map_defaults());
}

void ups_report_page_desc_init(ups_report_page_desc* desc, uint32_t struct_size) {
  ups::extras::write_defaults(desc, struct_size, ups::report::page_defaults());
}

ups_status ups_report_write_map(const char* path, const ups_report_map_desc* desc) {
  return guarded([&] {
    check_path(path);
    require(desc != nullptr, "desc is NULL");
    if (!ups::report::is_drawing_file(path))
      throw ups::report::Failure(std::string("path '") + path + "' must end in .png, .svg or .pdf");
    const auto map = ups::report::map_of(ups::extras::read_desc(desc, ups::report::map_defaults()));
    write_drawing(path, map_drawing(map.data, map.style.map), map_words(map.data, map.style.map), map.style.zoom);
  });
}

ups_status ups_report_write_page(const char* path, const ups_report_page_desc* desc) {
  return guarded([&] {
    check_path(path);
    require(desc != nullptr, "desc is NULL");
    const std::string page = ups::report::page_of(ups::extras::read_desc(desc, ups::report::page_defaults()));
    ups::extras::write_file(path, page.data(), page.size());
  });
}

const char* ups_report_last_error(void) { return last_error.get(); }
