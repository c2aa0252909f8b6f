// ups convert: a photometric file in the other format, and on stderr what that format does not hold of it.
#include <algorithm>
#include <cmath>

#include "common/atomic_file.h"
#include "platform/paths.h"
#include "tool/commands.h"
#include "tool/profile_file.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

// Up to what sizes lose in the four characters that EULUMDAT has for mm.
bool same_opening(const ups_profile_info& a, const ups_profile_info& b) {
  if (a.opening_shape != b.opening_shape) return false;
  if (a.opening_shape == UPS_OPENING_CYLINDER && a.opening_axis != b.opening_axis) return false;
  const auto same = [](float x, float y) { return std::abs(x - y) <= 1e-3f * std::max(x, y); };
  return std::equal(std::begin(a.opening_m), std::end(a.opening_m), std::begin(b.opening_m), same);
}

// What the written file, read again, lacks.
std::vector<std::string> losses(const ProfileReport& in, const ProfileReport& out) {
  std::vector<std::string> lost;
  const auto tell = [&](std::string text) { lost.push_back(std::move(text)); };
  if (in.info.ray_count > 0)
    tell(format("a far-field table of the %u rays is written; where they start is lost", in.info.ray_count));
  if (in.info.photometric_type != out.info.photometric_type)
    tell("the table of type " + std::string(in.info.photometric_type == UPS_PHOTOMETRIC_A ? "A" : "B") +
         " is resampled onto C-planes");
  if (!in.tilt_table.empty() && out.tilt_table.empty()) tell("the TILT table is lost");
  if (!same_opening(in.info, out.info))
    tell("the opening, " + opening_text(in.info) + ", is written as " + opening_text(out.info));
  if (in.is_eulumdat() != out.is_eulumdat() && in.info.c_count > 1)
    tell(std::string("C planes keep their numbers, though customs differ: its data sheet takes ") +
         (out.is_eulumdat() ? "C90 and not C0" : "C0 and not C90") +
         " as an outdoor luminaire's front, and turns the UGR table likewise");
  if (in.info.lamp_set_count > 1 && out.info.lamp_set_count < in.info.lamp_set_count)
    tell(format("of %u lamp sets one is written", in.info.lamp_set_count));
  return lost;
}

}  // namespace

int convert(const std::string& in, const std::string& out) {
  if (is_scene_file(in)) throw Failure(in + ": a scene; a photometric file can be converted");
  if (const std::string read = platform::resolved(in); !read.empty() && read == platform::resolved(out))
    throw Failure(out + ": is the file that is read; it would be lost. Another name for what is written would do");
  const Context context = make_context(1);
  const Profile profile = read_profile(context.get(), in);
  const WrittenProfile made = make_profile(out, profile.get());  // the command line admits .ies and .ldt alone
  const ProfileReport report = report_of_file(in, profile.get());
  for (const std::string& warning : report.warnings) put_warning(in + ": " + warning);
  ups_profile* again = nullptr;
  if (ups_profile_parse(context.get(), made.bytes.data(), made.bytes.size(), *photometric_format(out), &again))
    throw Failure(out + ": not written, as it could not be read again: " + ups_last_error());
  const Profile written(again);
  extras::write_file(out, made.bytes.data(), made.bytes.size());
  std::vector<std::string> lacks = losses(report, make_report(out, written.get()));
  append_once(lacks, made.lacks);
  for (const std::string& lack : lacks) put_warning(out + ": " + lack);
  return exit_done;
}

}  // namespace ups::tool
