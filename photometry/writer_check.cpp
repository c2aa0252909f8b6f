// What a written file lacks of the light that it was made of, by reading it back. Called by the writers.
#include <cmath>
#include <optional>

#include "photometry/metrics.h"
#include "photometry/writer_text.h"

namespace photometry {
namespace {

constexpr double tolerance = 1e-3;

}  // namespace

void check_written(const Photometry& p, const std::string& text, std::vector<std::string>& warnings) {
  const auto read_back = [&]() -> std::optional<Photometry> {
    try {
      return read(text.data(), text.size());
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& e) {
      warnings.push_back(std::string("the written file cannot be read back: ") + e.what());
      return std::nullopt;
    }
  };
  const std::optional<Photometry> written = read_back();
  if (!written) return;
  const auto compare = [&](const std::string& what, const char* unit, double before, double after) {
    if (std::abs(after - before) <= tolerance * before) return;
    const std::string percent = before > 0 ? " (" + shown(100 * (after / before - 1)) + " %)" : "";
    warnings.push_back(what + " of the written table is " + shown(after) + unit + ", that of the light " +
                       shown(before) + unit + percent);
  };
  compare("the flux", " lm", flux_lm(p), flux_lm(*written));
  compare("the peak", " cd", p.distribution.peak_cd(), written->distribution.peak_cd());
}

}  // namespace photometry
