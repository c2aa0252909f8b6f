// ups convert: a photometric file in the other format.
#include <cstdio>

#include "tool/commands.h"
#include "tool/profile_file.h"

namespace ups::tool {

int convert(const std::string& in, const std::string& out) {
  if (!photometric_format(in))
    throw Failure(in + ": not a kind of file that is read here: .ies, .ldt or another photometric one");
  const Context context = make_context(1);
  const Profile profile = read_profile(context.get(), in);
  write_profile(out, profile.get());  // the command line admits .ies and .ldt alone
  for (const std::string& warning : make_report(in, profile.get()).warnings)
    std::fprintf(stderr, "ups: warning: %s: %s\n", in.c_str(), warning.c_str());
  return exit_done;
}

}  // namespace ups::tool
