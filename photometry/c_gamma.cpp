// See c_gamma.h. Nodes of C and gamma make a table by their product, so that the error of one step is summed over the
// whole other angle: along C at every row, along gamma at every plane.
#include "photometry/c_gamma.h"

#include <algorithm>
#include <cmath>

#include "photometry/planes.h"

namespace photometry {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;
constexpr double flux_and_peak = 1e-3;       // that part from the source's
constexpr double most_missed = 1e-3;         // of the flux, of an adaptive table
constexpr double most_missed_evenly = 5e-3;  // of an even one
constexpr size_t most_planes = 720, most_rows = 361, most_values = 150'000;
constexpr double base_c = 15, base_gamma = 5;
constexpr double dim = 1e-3;  // of the peak: no node of its own

double rounded(double angle, double per_degree) { return std::round(angle * per_degree) / per_degree; }
// To the decimals that six characters have.
double rounded(double angle) { return rounded(angle, angle < 100 ? 1000 : 100); }

void add_node(std::vector<double>& nodes, double angle) {
  const auto at = std::lower_bound(nodes.begin(), nodes.end(), angle);
  if (at == nodes.end() || *at != angle) nodes.insert(at, angle);
}

std::vector<double> multiples(double step, double end, bool closed) {
  std::vector<double> out;
  for (int i = 0; closed ? i * step <= end : i * step < end; ++i) out.push_back(i * step);
  return out;
}

class CGammaGrid {
 public:
  explicit CGammaGrid(const Distribution& source)
      : source_(source),
        symmetry_(mirror_symmetry_of(source)),
        highest_(source.c_deg().front() < -90 || source.c_deg().back() > 90 ? 180 : 90) {}
  Distribution find();

 private:
  struct Step {
    bool along_c;
    size_t index;
    double missed_lm;
  };
  double eval(double c_deg, double gamma_deg) const {
    const double g = gamma_deg * degree, c = c_deg * degree;
    return source_.eval(std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g));
  }
  double c_end(size_t i) const { return i + 1 < c_.size() ? c_[i + 1] : 360; }
  bool even(double step, Distribution& out);
  bool keeps_flux_and_peak(const Distribution& table) const;
  std::vector<Step> steps(const Distribution& table) const;
  static double missed(const std::vector<Step>& steps);
  Distribution with_peak(const Distribution& table) const;
  void start();
  void add_brightest();
  bool refine(std::vector<Step> steps);
  bool part(bool along_c, double from, double to);
  void add_c(double c_deg);

  const Distribution& source_;
  const Symmetry symmetry_;
  const double highest_;
  std::vector<double> c_, gamma_;
};

bool CGammaGrid::keeps_flux_and_peak(const Distribution& table) const {
  const auto near = [](double a, double b) { return std::abs(a - b) <= flux_and_peak * b; };
  return near(table.band_flux_lm(), source_.band_flux_lm()) && near(table.peak_cd(), source_.peak_cd());
}

// What linear interpolation misses within each step, from three places in it.
std::vector<CGammaGrid::Step> CGammaGrid::steps(const Distribution& table) const {
  std::vector<Step> out;
  const auto error = [&](double c0, double c1, double g0, double g1, double i0, double i1) {
    double sum = 0;
    for (double t : {0.25, 0.5, 0.75}) {
      const double g = g0 + t * (g1 - g0);
      sum += std::abs(eval(c0 + t * (c1 - c0), g) - (i0 + t * (i1 - i0))) * std::sin(g * degree) / 3;
    }
    return sum;
  };
  const size_t planes = c_.size(), rows = gamma_.size();
  for (size_t j = 0; j + 1 < rows; ++j) {
    double lm = 0;
    for (size_t i = 0; i < planes; ++i) {
      const double width = 0.5 * (c_end(i) - (i > 0 ? c_[i - 1] : c_.back() - 360));
      lm += width * error(c_[i], c_[i], gamma_[j], gamma_[j + 1], table.at(i, j), table.at(i, j + 1));
    }
    out.push_back({false, j, lm * (gamma_[j + 1] - gamma_[j]) * degree * degree});
  }
  for (size_t i = 0; i < planes; ++i) {
    double lm = 0;
    for (size_t j = 0; j < rows; ++j) {
      const double height = 0.5 * (gamma_[std::min(j + 1, rows - 1)] - gamma_[j > 0 ? j - 1 : 0]);
      lm += height * error(c_[i], c_end(i), gamma_[j], gamma_[j], table.at(i, j), table.at((i + 1) % planes, j));
    }
    out.push_back({true, i, lm * (c_end(i) - c_[i]) * degree * degree});
  }
  return out;
}

double CGammaGrid::missed(const std::vector<Step>& steps) {
  double lm = 0;
  for (const Step& s : steps) lm += s.missed_lm;
  return lm;
}

bool CGammaGrid::even(double step, Distribution& out) {
  c_ = multiples(step, 360, false);
  gamma_ = multiples(step, highest_, true);
  out = source_.resampled(c_, gamma_);
  return keeps_flux_and_peak(out) && missed(steps(out)) <= most_missed_evenly * source_.band_flux_lm();
}

// With the mirror images of a symmetric source, so that its table can be written in part.
void CGammaGrid::add_c(double c_deg) {
  const bool h = symmetry_ == Symmetry::c0_c180 || symmetry_ == Symmetry::quadrants,
             v = symmetry_ == Symmetry::c90_c270 || symmetry_ == Symmetry::quadrants;
  const auto add = [&](double c) { add_node(c_, rounded(std::fmod(c + 360, 360))); };
  const double c = rounded(c_deg, 100);
  add(c);
  if (h) add(360 - c);
  if (v) add(180 - c);
  if (h && v) add(180 + c);
}

// A peak keeps its value where its node is less than 0.005 degrees beside it, for want of digits.
Distribution CGammaGrid::with_peak(const Distribution& table) const {
  std::vector<double> values;
  for (size_t i = 0; i < c_.size(); ++i)
    for (size_t j = 0; j < gamma_.size(); ++j) values.push_back(table.at(i, j));
  for (size_t i = 0; i < source_.c_deg().size(); ++i)
    for (size_t j = 0; j < source_.gamma_deg().size(); ++j) {
      if (source_.at(i, j) < source_.peak_cd()) continue;
      double c, gamma;
      source_.node_direction(i, j, c, gamma);
      const auto plane = std::find(c_.begin(), c_.end(), rounded(std::fmod(rounded(c, 100), 360))),
                 row = std::find(gamma_.begin(), gamma_.end(), rounded(gamma));
      if (plane != c_.end() && row != gamma_.end())
        values[size_t(plane - c_.begin()) * gamma_.size() + size_t(row - gamma_.begin())] = source_.peak_cd();
    }
  return Distribution(c_, gamma_, std::move(values));
}

// Of each base step that has light, so that no beam lies between two nodes.
void CGammaGrid::add_brightest() {
  struct Bright {
    double cd = 0, deg = 0;
  };
  std::vector<Bright> by_c(size_t(360 / base_gamma)), by_gamma(size_t(180 / base_gamma) + 1);
  for (size_t i = 0; i < source_.c_deg().size(); ++i)
    for (size_t j = 0; j < source_.gamma_deg().size(); ++j) {
      const double cd = source_.at(i, j);
      if (!(cd > dim * source_.peak_cd())) continue;
      double c, gamma;
      source_.node_direction(i, j, c, gamma);
      Bright &at_c = by_c[std::min(by_c.size() - 1, size_t(c / base_gamma))],
             &at_gamma = by_gamma[size_t(gamma / base_gamma)];
      if (cd > at_c.cd && gamma > 0 && gamma < 180) at_c = {cd, c};
      if (cd > at_gamma.cd) at_gamma = {cd, gamma};
    }
  for (const Bright& b : by_c)
    if (b.cd > 0) add_c(rounded(b.deg, 20));
  for (const Bright& b : by_gamma)
    if (b.cd > 0 && b.deg <= highest_) add_node(gamma_, rounded(b.deg, 20));
}

void CGammaGrid::start() {
  c_ = multiples(base_c, 360, false);
  gamma_ = multiples(base_gamma, highest_, true);
  add_brightest();
  add_c(source_.peak_c_deg());
  if (source_.peak_gamma_deg() < highest_) add_node(gamma_, rounded(source_.peak_gamma_deg()));
}

// The multiples of the largest step that has one inside. False where there is none.
bool CGammaGrid::part(bool along_c, double from, double to) {
  for (double per_degree : {0.2, 1.0, 2.0, 10.0, 20.0}) {
    const double first = std::floor(from * per_degree + 1e-6) + 1, last = std::ceil(to * per_degree - 1e-6) - 1;
    if (first > last) continue;
    for (double k = first; k <= last; ++k) along_c ? add_c(k / per_degree) : add_node(gamma_, k / per_degree);
    return true;
  }
  return false;
}

// Parts the worst steps of those that miss more than their share. False where nothing more can be.
bool CGammaGrid::refine(std::vector<Step> steps) {
  const double flux = source_.band_flux_lm();
  if (missed(steps) <= most_missed * flux) return false;
  const std::vector<double> c = c_, gamma = gamma_;
  const auto end = [&](size_t i) { return i + 1 < c.size() ? c[i + 1] : 360; };
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.missed_lm > b.missed_lm; });
  bool parted = false;
  for (const Step& s : steps) {
    if (s.missed_lm <= 0.5 * most_missed * flux / double(s.along_c ? c.size() : gamma.size())) break;
    if (s.along_c ? c_.size() + 8 > most_planes : gamma_.size() + 4 > most_rows) continue;
    if (c_.size() * gamma_.size() > most_values) break;
    parted |= s.along_c ? part(true, c[s.index], end(s.index)) : part(false, gamma[s.index], gamma[s.index + 1]);
  }
  return parted;
}

Distribution CGammaGrid::find() {
  double finest = 90;
  for (const std::vector<double>* angle : {&source_.c_deg(), &source_.gamma_deg()})
    for (size_t i = 0; i + 1 < angle->size(); ++i) finest = std::min(finest, (*angle)[i + 1] - (*angle)[i]);
  Distribution table({0}, {0, 180}, {0, 0});
  int tried = 0;
  for (double step : {5.0, 2.5, 1.0}) {
    if (step > finest && step > 1) continue;
    if (even(step, table)) return table;
    if (++tried == 2) break;
  }
  start();
  do {
    table = source_.resampled(c_, gamma_);
  } while (refine(steps(table)));
  return with_peak(table);
}

}  // namespace

Distribution in_c_gamma(const Distribution& d) {
  return d.type() == PhotometricType::c ? d : CGammaGrid(d).find();
}

}  // namespace photometry
