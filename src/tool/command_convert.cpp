// ups convert: a photometric file in the other format.
#include <cstdio>

#include "common/atomic_file.h"
#include "tool/commands.h"
#include "tool/profile_file.h"

namespace ups::tool {

int convert(const std::string& in, const std::string& out) {
  if (!photometric_format(in))
    throw Failure(in + ": not a kind of file that is read here: .ies, .ldt or another photometric one");
  const Context context = make_context(1);
  const Profile profile = read_profile(context.get(), in);
  const ups_profile_format format = *photometric_format(out);  // the command line admits .ies and .ldt alone
  std::string bytes;
  try {
    bytes = read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_profile_write(profile.get(), format, to, capacity, needed);
    });
  } catch (const Failure& e) {
    throw Failure(out + ": " + e.what());
  }
  extras::write_file(out, bytes.data(), bytes.size());
  for (const std::string& warning : make_report(in, profile.get()).warnings)
    std::fprintf(stderr, "ups: warning: %s: %s\n", in.c_str(), warning.c_str());
  return exit_done;
}

}  // namespace ups::tool
