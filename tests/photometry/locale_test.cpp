// Are files read and written alike where the program around the library has a locale of decimal commas?
#include <locale>

#include "../support/german_locale.h"
#include "files.h"

namespace photometry {
namespace {

using namespace test;

struct CommaAndDots : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class WithCommas {  // of the C++ streams and of the C functions
 public:
  WithCommas() : german_(LC_NUMERIC) {}
  ~WithCommas() { std::locale::global(before_); }
  bool of_the_c_library() const { return german_.is_set(); }

 private:
  std::locale before_ = std::locale::global(std::locale(std::locale::classic(), new CommaAndDots));
  ups::test::GermanLocale german_;
};

TEST(Locale, ChangesNothingOfWhatIsReadAndWritten) {
  const std::string tm33 =
      "<IESTM33-22><Emitter><LuminousData><LuminousIntensity><IntData h='0' v='0'>1234.5</IntData>"
      "<IntData h='0' v='90'>0.5</IntData></LuminousIntensity></LuminousData></Emitter></IESTM33-22>";
  const std::string ies =
      "IESNA:LM-63-2002\nTILT=NONE\n1 1000.5 1 3 1 1 2 0.25 0.5 0\n1 1 12.5\n0 22.5 90\n0\n12345.25 40.5 0\n";
  bool in_c = false;
  for (const std::string& text : {tm33, ies}) {
    const Photometry plain = read_text(text);
    const std::string plain_ies = write_ies(plain), plain_ldt = write_eulumdat(plain);
    const double ldt_peak_cd = read_text(plain_ldt).distribution.peak_cd();
    const WithCommas commas;
    in_c = commas.of_the_c_library();
    const Photometry p = read_text(text);
    EXPECT_EQ(p.distribution.eval(0.3, 0.1, -0.9), plain.distribution.eval(0.3, 0.1, -0.9));
    EXPECT_EQ(p.distribution.peak_cd(), plain.distribution.peak_cd());
    EXPECT_EQ(p.rated_flux_lm, plain.rated_flux_lm);
    EXPECT_EQ(write_ies(p), plain_ies);
    EXPECT_EQ(write_eulumdat(p), plain_ldt);
    EXPECT_EQ(read_text(plain_ldt).distribution.peak_cd(), ldt_peak_cd);
    EXPECT_EQ(p.warnings, plain.warnings);
    try {
      Distribution({0}, {1500.5, 90}, {1, 1});
      ADD_FAILURE() << "an angle of 1500.5 degrees is none";
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find("= 1500.5 is"), std::string::npos) << e.what();
    }
  }
  if (!in_c) GTEST_SKIP() << "C++ streams alone: samples/setup.sh test installs what a German locale is made of";
}

}  // namespace
}  // namespace photometry
