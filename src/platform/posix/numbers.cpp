// See numbers.h.
#include "platform/numbers.h"

#include <locale.h>
#include <math.h>
#if __has_include(<xlocale.h>)
#include <xlocale.h>
#endif

#include <atomic>
#include <new>

namespace ups::platform {

double log_gamma(double x) {
  int sign;
  return lgamma_r(x, &sign);
}

namespace {

// The process's one, once there was memory for it.
locale_t plain_locale() {
  static std::atomic<locale_t> plain{};
  if (const locale_t made = plain.load(std::memory_order_acquire)) return made;
  const locale_t mine = newlocale(LC_ALL_MASK, "C", locale_t(0));
  if (!mine) throw std::bad_alloc();
  locale_t first = locale_t(0);
  if (plain.compare_exchange_strong(first, mine, std::memory_order_acq_rel)) return mine;
  freelocale(mine);  // another thread was first
  return first;
}

}  // namespace

PointInNumbers::PointInNumbers() : before_(uselocale(plain_locale())) {}

PointInNumbers::~PointInNumbers() { uselocale(locale_t(before_)); }

}  // namespace ups::platform
