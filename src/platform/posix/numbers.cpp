// See numbers.h.
#include "platform/numbers.h"

#include <locale.h>
#include <math.h>
#if __has_include(<xlocale.h>)
#include <xlocale.h>
#endif

namespace ups::platform {

double log_gamma(double x) {
  int sign;
  return lgamma_r(x, &sign);
}

namespace {

locale_t plain_locale() {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", locale_t(0));
  return plain;
}

}  // namespace

PointInNumbers::PointInNumbers() {
  if (plain_locale()) before_ = uselocale(plain_locale());
}

PointInNumbers::~PointInNumbers() {
  if (before_) uselocale(locale_t(before_));
}

}  // namespace ups::platform
