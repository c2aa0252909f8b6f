// Photometric files with exhausted memory: parsed and written. Every allocation fails once, and all from one on
// (UPS_MEMORY_SWEEP=all; else they are sampled).
#include <fstream>
#include <iterator>

#include "sweep.h"
#include "ups/ups_photometry.h"

using namespace ups::test;

namespace {

std::string content(const std::string& name) {
  std::ifstream file(UPS_PHOTOMETRIC_FILES "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const char tm33[] =
    "<IESTM33-22><Version>1.1</Version><Header><Manufacturer>A</Manufacturer><Description>one</Description></Header>"
    "<Emitter><Quantity>1</Quantity><Description>LED</Description><LuminousData><LuminousIntensity>"
    "<IntData v='0' h='0'>100</IntData><IntData v='45' h='0'>80</IntData><IntData v='90' h='0'>0</IntData>"
    "</LuminousIntensity></LuminousData></Emitter></IESTM33-22>";

// The first status that is not OK of all that a program asks of a file.
ups_status read_and_write(ups_context* context, const std::string& bytes, ups_profile_format format) {
  ups_profile* profile = nullptr;
  ups_status worst = ups_profile_parse(context, bytes.data(), bytes.size(), UPS_PROFILE_AUTO, &profile);
  if (worst != UPS_OK) return worst;
  const auto keep = [&](ups_status status) { worst = worst == UPS_OK ? status : worst; };
  size_t needed = 0;
  keep(ups_profile_write(profile, format, nullptr, 0, &needed));
  keep(ups_profile_get_write_warnings(profile, format, nullptr, 0, &needed));
  auto info = make_desc<ups_profile_info>([](ups_profile_info* i, uint32_t size) { i->struct_size = size; });
  keep(ups_profile_get_info(profile, &info));
  ups_profile_destroy(profile);
  return worst;
}

class MemoryOfProfiles : public testing::TestWithParam<const char*> {};

TEST_P(MemoryOfProfiles, AreReadAndWritten) {
  begin_watch();
  const std::string name = GetParam(), bytes = name == "tm33" ? tm33 : content(name);
  ASSERT_FALSE(bytes.empty()) << name;
  ups_context* context = nullptr;
  ASSERT_EQ(ups_context_create(nullptr, &context), UPS_OK) << ups_last_error();
  // Not as EULUMDAT, which has types A and B resampled, for seconds.
  const bool is_ies = name.find(".ies") != name.npos;
  const Call call = [&] {
    return read_and_write(context, bytes, is_ies ? UPS_PROFILE_IES_LM63 : UPS_PROFILE_EULUMDAT);
  };
  expect_nothing_lost(call, low_effort() ? 25 : 100, 20);
  ups_context_destroy(context);
}

INSTANTIATE_TEST_SUITE_P(Of, MemoryOfProfiles,
                         testing::Values("s08_typeC_asym.ies", "s09_typeB_asym.ies", "s01_lm63_1986.ies",
                                         "l03_isym0_asym.ldt", "tm33"),
                         [](const auto& file) {
                           const std::string name = file.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
