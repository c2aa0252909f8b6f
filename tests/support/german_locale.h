// The C library's German locale, whose numbers have commas. samples/setup.sh test installs what it is made of; the build
// makes it (tests/CMakeLists.txt), as few machines have one.
#pragma once
#include <clocale>
#include <cstdlib>
#include <string>

namespace ups::test {

class GermanLocale {
 public:
  explicit GermanLocale(int category) : category_(category) {
    setenv("LOCPATH", UPS_TEST_LOCALES, 1);
    is_set_ = std::setlocale(category, "de_DE.UTF-8") != nullptr;
  }
  ~GermanLocale() { std::setlocale(category_, "C"); }
  GermanLocale(const GermanLocale&) = delete;
  GermanLocale& operator=(const GermanLocale&) = delete;
  bool is_set() const { return is_set_ && std::string(std::localeconv()->decimal_point) == ","; }

 private:
  const int category_;
  bool is_set_;
};

}  // namespace ups::test
