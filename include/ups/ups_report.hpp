// UPS extra for C++17: maps of illuminance and luminance, and the lighting report, over ups_report.h, by the rules of
// ups.hpp. Link the library ups_report, and the core.
#ifndef UPS_REPORT_HPP
#define UPS_REPORT_HPP

#include "hpp/base.hpp"
#include "ups_report.h"

namespace ups {
inline namespace v0_1 {
namespace detail {

inline ups_status check_report(ups_status status) {
  if (status < 0) throw Error(status, ups_report_last_error());
  return status;
}

}  // namespace detail

struct ReportStyleDesc : ups_report_style_desc {
  ReportStyleDesc() noexcept { ups_report_style_desc_init(this, sizeof(ups_report_style_desc)); }
};
struct ReportMapDesc : ups_report_map_desc {
  ReportMapDesc() noexcept { ups_report_map_desc_init(this, sizeof(ups_report_map_desc)); }
};
struct ReportPageDesc : ups_report_page_desc {
  ReportPageDesc() noexcept { ups_report_page_desc_init(this, sizeof(ups_report_page_desc)); }
};

// Paths are UTF-8, of a map they end in .png, .svg or .pdf. What the description points to is read during the call. The
// file appears whole or not at all.
inline void report_write_map(const std::string &path, const ReportMapDesc &desc) {
  detail::check_report(ups_report_write_map(detail::c_path(path), &desc));
}
inline void report_write_page(const std::string &path, const ReportPageDesc &desc) {
  detail::check_report(ups_report_write_page(detail::c_path(path), &desc));
}

}  // namespace v0_1
}  // namespace ups

#endif
