// What a written file lacks of the light that it was made of, by reading it back. Called by the writers.
#include <cmath>
#include <optional>

#include "photometry/metrics.h"
#include "photometry/writer_text.h"

namespace photometry {
namespace {

constexpr double tolerance = 1e-3, tolerance_of_area = 0.02;

// By what is seen of them from below and from the sides: luminance and glare go by it.
void compare_openings(const Opening& before, const Opening& after, std::vector<std::string>& warnings) {
  struct View {
    const char* name;
    double x, y, z;
  };
  for (const View& v : {View{"from below", 0, 0, -1}, View{"at C0, gamma 60", 0.866, 0, -0.5},
                        View{"at C90, gamma 60", 0, 0.866, -0.5}}) {
    const double had = projected_area_m2(before, v.x, v.y, v.z), has = projected_area_m2(after, v.x, v.y, v.z);
    if (std::abs(has - had) <= tolerance_of_area * had) continue;
    warnings.push_back("the opening of the written file has " + shown(has) + " m2 " + v.name + ", that of the light " +
                       shown(had) + " m2: the format has no such shape, and luminance and glare differ as much");
    return;
  }
}

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
  compare_openings(p.opening, written->opening, warnings);
}

}  // namespace photometry
