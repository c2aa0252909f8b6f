// A photometric file as the commands use it: read, written, and in words. Called by the commands info, convert and
// goniometer.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/drawing_file.h"
#include "report/profile_data.h"
#include "tool/handles.h"

namespace ups::tool {

// By its name. None: not a photometric file.
std::optional<ups_profile_format> photometric_format(const std::string& file);
inline constexpr const char* known_extensions = ".ies, .ldt, .xml, .tm25ray, .sdf, .dat or .ray";
bool is_scene_file(const std::string& file);  // by its name or its first bytes

// By its content, whatever its name. Throws Failure that names the file.
Profile read_profile(ups_context* context, const std::string& file);
struct WrittenProfile {
  std::string bytes;
  std::vector<std::string> lacks;  // what the file does not hold as the profile has it, such as flux and peak
};
// As .ies or .ldt, by its name; writes nothing yet. Throws Failure that names the file.
WrittenProfile make_profile(const std::string& file, const ups_profile* profile);
inline bool is_written_format(const std::string& file) {
  return lower_extension(file) == ".ies" || lower_extension(file) == ".ldt";
}

// make_report() of a file that was read; where its name tells another format than its content, a warning more.
ProfileReport report_of_file(const std::string& file, const ups_profile* profile);

std::string to_text(const ProfileReport& report);  // a page for one file
std::string table_head(size_t name_width);         // and, for many, lines of a table
// name: of the file, for the first column.
std::string table_line(const ProfileReport& report, const std::string& name, size_t name_width);
std::string table_error(const std::string& file, const std::string& error, const std::string& name, size_t name_width);

}  // namespace ups::tool
