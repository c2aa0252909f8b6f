// Emission by piecewise-constant densities, after Grittmann, Pérard-Gayot, Slusallek, Křivánek (2018), Efficient
// caustic rendering with lightweight photon mapping. A density in proportion to the root of what the square of the
// value amounts to has the least variance of all (Cauchy-Schwarz), in a histogram as among emitters.
#include "emitter/guide.h"

#include <numeric>

#include "base/rng.h"

namespace ups {
namespace {

constexpr double as_untrained = 0.25;  // of the choice of emitter: no more than four times the noise where training errs
constexpr double uniform = 0.2;        // of every histogram
constexpr double aimed = 0.2;          // of one that has aims
constexpr uint32_t coarsest = 2;       // 4 x 4
constexpr double least_gain = 1.2;     // of a histogram, in variance: less is not worth looking densities up
constexpr size_t paths_per_cell = 8;   // of the cells that are worth anything
constexpr size_t most_numbers = size_t(1) << 21;  // of all histograms: 8 MB

size_t numbers(uint32_t n) { return size_t(n) * (n + 1); }

// Every second bit of z, from the first on.
uint32_t even_bits(uint64_t z) {
  uint32_t out = 0;
  for (uint32_t k = 0; k < 32; ++k) out |= uint32_t(z >> (2 * k) & 1) << k;
  return out;
}

uint32_t cell_of(float u, uint32_t n) { return std::min(uint32_t(std::max(u, 0.0f) * float(n)), n - 1); }

// The mean of each cell and its neighbours: a few paths say little about where exactly the next ones should go.
std::vector<double> blurred(const std::vector<double>& in, uint32_t n) {
  std::vector<double> out(in.size());
  for (uint32_t y = 0; y < n; ++y)
    for (uint32_t x = 0; x < n; ++x) {
      double sum = 0;
      uint32_t count = 0;
      for (uint32_t j = y > 0 ? y - 1 : 0; j <= std::min(y + 1, n - 1); ++j)
        for (uint32_t i = x > 0 ? x - 1 : 0; i <= std::min(x + 1, n - 1); ++i, ++count) sum += in[j * n + i];
      out[y * n + x] = sum / count;
    }
  return out;
}

// The probabilities of cells in which the squares of values amount to `moment`.
std::vector<double> shares(const std::vector<double>& moment, uint32_t n) {
  std::vector<double> out = blurred(moment, n);
  double sum = 0;
  for (double& s : out) sum += s = std::sqrt(s);
  for (double& s : out) s = uniform / double(out.size()) + (sum > 0 ? (1 - uniform) * s / sum : 0);
  return out;
}

// The same of more cells a side.
std::vector<double> refined(const std::vector<double>& share, uint32_t from, uint32_t to) {
  std::vector<double> out(size_t(to) * to);
  const uint32_t k = to / from;
  for (uint32_t y = 0; y < to; ++y)
    for (uint32_t x = 0; x < to; ++x) out[size_t(y) * to + x] = share[size_t(y / k) * from + x / k] / (double(k) * k);
  return out;
}

double moment_through(const std::vector<double>& share, const std::vector<double>& moment) {
  double sum = 0;
  for (size_t k = 0; k < share.size(); ++k) sum += moment[k] / (share[k] * double(share.size()));
  return sum;
}

// Cumulative probabilities, in proportion to the shares.
void accumulate_to_one(const double* share, uint32_t n, float* end) {
  const double sum = std::accumulate(share, share + n, 0.0);
  double below = 0;
  for (uint32_t k = 0; k < n; ++k) end[k] = float((below += share[k]) / sum);
  end[n - 1] = 1;
}

// Which of n cumulative probabilities u falls below; u becomes the place in it. Its distance from the next one is kept
// large enough that adding it to an index stays exact.
uint32_t descend(const float* cumulative, uint32_t n, float& u, float& probability) {
  const uint32_t k = std::min(uint32_t(std::upper_bound(cumulative, cumulative + n, u) - cumulative), n - 1);
  const float start = k > 0 ? cumulative[k - 1] : 0;
  probability = cumulative[k] - start;
  u = std::clamp((u - start) / probability, 0.0f, 1 - 0x1p-17f);
  return k;
}

float probability_at(const float* cumulative, uint32_t k) { return cumulative[k] - (k > 0 ? cumulative[k - 1] : 0); }

}  // namespace

// ---- training ----

uint32_t GuideTraining::finest_cell(const Vec2& square) {
  return cell_of(square.y, 1u << finest) << finest | cell_of(square.x, 1u << finest);
}

uint64_t GuideTraining::key_of(uint32_t emitter, const Vec2& square) const {
  const uint32_t x = cell_of(square.x, 1u << level_), y = cell_of(square.y, 1u << level_);
  uint64_t key = emitter;
  for (uint32_t k = level_; k-- > 0;) key = key << 2 | (y >> k & 1) << 1 | (x >> k & 1);
  return key;
}

void GuideTraining::add(const EmitterSet& emitters, const EmissionGuide& drawn_with, uint32_t emitter,
                        const Vec2& square, double value) {
  const double density = double(drawn_with.probability(emitters, emitter)) * drawn_with.density(emitter, square);
  const double moment = value * value * density;
  if (!(moment > 0) || !std::isfinite(moment)) return;
  // By a hash: paths that follow one another may be strata of one another.
  const bool half = mix64(added_++) & 1;
  cells_.push_back({key_of(emitter, square), 1, {half ? 0 : moment, half ? moment : 0}});
  if (cells_.size() >= compact_at_) compact();
}

// One entry a cell; where these are too many, four cells become one.
void GuideTraining::compact() {
  const auto join = [&] {
    size_t last = 0;
    for (size_t k = 1; k < cells_.size(); ++k) {
      if (cells_[k].key != cells_[last].key) {
        cells_[++last] = cells_[k];
        continue;
      }
      cells_[last].paths += cells_[k].paths;
      for (int half = 0; half < 2; ++half) cells_[last].moment[half] += cells_[k].moment[half];
    }
    cells_.resize(std::min(cells_.size(), last + 1));
  };
  std::stable_sort(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) { return a.key < b.key; });
  join();
  while (cells_.size() > most_cells && level_ > 0) {
    --level_;
    for (Cell& c : cells_) c.key >>= 2;
    join();
  }
  compact_at_ = std::max(compact_at_, 2 * cells_.size());
}

// As fine as there are enough paths for: in the cells that have any, and in all, to know what the others are not worth.
uint32_t GuideTraining::resolution(size_t begin, size_t end) const {
  size_t paths = 0;
  for (size_t k = begin; k < end; ++k) paths += cells_[k].paths;
  for (uint32_t level = level_; level >= coarsest; --level) {
    size_t lit = 0;
    for (size_t k = begin; k < end; ++k)
      lit += k == begin || (cells_[k].key ^ cells_[k - 1].key) >> (2 * (level_ - level)) != 0;
    if (paths >= paths_per_cell * lit && 4 * paths >= size_t(1) << (2 * level)) return 1u << level;
  }
  return 0;
}

// ---- the guide ----

EmissionGuide::EmissionGuide(const EmitterSet& emitters, GuideTraining training, std::span<const uint8_t> dark) {
  if (training.empty() && dark.empty()) return;
  training.compact();
  std::vector<size_t> begin(emitters.size() + 1, training.cells_.size());
  for (size_t k = training.cells_.size(); k-- > 0;) begin[training.emitter_of(k)] = k;
  for (size_t i = emitters.size(); i-- > 0;) begin[i] = std::min(begin[i], begin[i + 1]);

  histograms_.resize(emitters.size());
  size_t total = 0;
  const auto is_dark = [&](size_t i) { return !dark.empty() && dark[i] != 0; };
  for (size_t i = 0; i < emitters.size(); ++i) {
    if (emitters[i].kind() != EmitterKind::rays && !is_dark(i))
      histograms_[i].n =
          training.has_aims(i) ? 1u << GuideTraining::finest : training.resolution(begin[i], begin[i + 1]);
    total += numbers(histograms_[i].n);
  }
  for (uint32_t most = 1u << GuideTraining::finest; total > most_numbers; most /= 2)
    for (Histogram& h : histograms_)
      if (h.n == most) {
        total -= numbers(h.n);
        h.n = most > 1u << coarsest ? most / 2 : 0;
        total += numbers(h.n);
      }

  cumulative_.reserve(total);
  std::vector<double> worth(emitters.size()), untrained(emitters.size());
  double worth_sum = 0, untrained_sum = 0;
  for (size_t i = 0; i < emitters.size(); ++i) {
    if (is_dark(i)) continue;
    worth_sum += worth[i] = std::sqrt(fill(histograms_[i], training, i, begin[i], begin[i + 1]));
    untrained_sum += untrained[i] = emitters.emission_probability(i);
  }
  const double share = worth_sum > 0 ? as_untrained : 1;
  for (size_t i = 0; i < emitters.size(); ++i)
    worth[i] = (untrained_sum > 0 ? share * untrained[i] / untrained_sum : 0) +
               (worth_sum > 0 ? (1 - share) * worth[i] / worth_sum : 0);
  choice_ = DiscreteDistribution(worth);
}

namespace {

// Into the probabilities of cells.
void add_aims(const std::vector<GuideTraining::Aim>& aims, double densest, uint32_t n,
              std::vector<double>& share) {
  double sum = 0;
  for (const GuideTraining::Aim& a : aims) sum += a.weight;
  const uint32_t finest = 1u << GuideTraining::finest, k = finest / n;
  const double of_aims = std::min(aimed, densest * double(aims.size()) / (double(finest) * finest));
  for (double& s : share) s *= 1 - of_aims;
  for (const GuideTraining::Aim& a : aims)
    share[size_t(a.cell / finest / k) * n + a.cell % finest / k] += of_aims * a.weight / sum;
}

struct Trained {
  std::vector<double> share;  // n x n
  uint32_t n = 1;
  double moment = 0;  // second, of what the emitter's paths will be worth
};

// halves: of the moments. Each is judged by the histogram of the other, as a few paths of great worth make any
// histogram look good that has seen them; one that does not pass is dropped.
Trained trained(const std::vector<double> (&halves)[2], uint32_t n) {
  std::vector<double> all(halves[0]);
  for (size_t k = 0; k < all.size(); ++k) all[k] += halves[1][k];
  const Trained even{{1.0}, 1, std::accumulate(all.begin(), all.end(), 0.0)};
  if (n == 1 || !(even.moment > 0)) return even;
  const double guided =
      moment_through(shares(halves[0], n), halves[1]) + moment_through(shares(halves[1], n), halves[0]);
  return guided * least_gain > even.moment ? even : Trained{shares(all, n), n, guided};
}

}  // namespace

// Returns the second moment of what the emitter's paths will be worth.
double EmissionGuide::fill(Histogram& h, const GuideTraining& training, size_t emitter, size_t begin, size_t end) {
  const bool aims = h.n > 0 && training.has_aims(emitter);
  const uint32_t n = std::max(1u, aims ? std::min(h.n, training.resolution(begin, end)) : h.n);
  std::vector<double> halves[2] = {std::vector<double>(size_t(n) * n), std::vector<double>(size_t(n) * n)};
  for (size_t k = begin; k < end; ++k) {
    const uint32_t side = 1u << training.level_, x = even_bits(training.cells_[k].key) % side,
                   y = even_bits(training.cells_[k].key >> 1) % side;
    for (int half = 0; half < 2; ++half)
      halves[half][size_t(y / (side / n)) * n + x / (side / n)] += training.cells_[k].moment[half];
  }
  Trained t = trained(halves, n);
  if (aims) {
    t.share = refined(t.share, t.n, h.n), t.n = h.n;
    add_aims(training.aims_[emitter], training.densest_, h.n, t.share);
  }
  h.n = t.n > 1 ? t.n : 0;
  if (h.n == 0) return t.moment;

  h.first = uint32_t(cumulative_.size());
  cumulative_.resize(h.first + numbers(h.n));
  float* row_end = cumulative_.data() + h.first;
  std::vector<double> rows(h.n);
  for (uint32_t y = 0; y < h.n; ++y) {
    const double* in_row = t.share.data() + size_t(y) * h.n;
    rows[y] = std::accumulate(in_row, in_row + h.n, 0.0);
    accumulate_to_one(in_row, h.n, row_end + h.n + size_t(y) * h.n);
  }
  accumulate_to_one(rows.data(), h.n, row_end);
  return t.moment;
}

float EmissionGuide::warp(const Histogram& h, Vec2& u) const {
  const float* rows = cumulative_.data() + h.first;
  const float n = float(h.n);
  float of_row, of_cell;
  const uint32_t y = descend(rows, h.n, u.y, of_row);
  const uint32_t x = descend(rows + h.n + size_t(y) * h.n, h.n, u.x, of_cell);
  u = {(float(x) + u.x) / n, (float(y) + u.y) / n};
  return of_row * n * (of_cell * n);
}

float EmissionGuide::density(size_t i, const Vec2& square) const {
  if (resolution(i) == 0) return 1;
  const Histogram& h = histograms_[i];
  const float* rows = cumulative_.data() + h.first;
  const float n = float(h.n);
  const uint32_t y = cell_of(square.y, h.n), x = cell_of(square.x, h.n);
  return probability_at(rows, y) * n * (probability_at(rows + h.n + size_t(y) * h.n, x) * n);
}

float EmissionGuide::least_density(size_t i) const {
  return resolution(i) == 0 ? 1.0f : float(uniform * (1 - aimed));
}

EmitterSet::Choice EmissionGuide::choose(const EmitterSet& emitters, double u) const {
  if (choice_.size() == 0) return emitters.choose_emission(u);
  if (!(choice_.total() > 0)) return {};
  const DiscreteDistribution::Sample s = choice_.sample(u);
  return {uint32_t(s.index), s.probability, s.u};
}

float EmissionGuide::probability(const EmitterSet& emitters, size_t i) const {
  return choice_.size() == 0 ? emitters.emission_probability(i) : choice_.probability(i);
}

bool EmissionGuide::sample(const EmitterSet& emitters, size_t i, const Vec2& u_position, const Vec2& u_direction,
                           EmissionSample& out, Vec2& square) const {
  const Emitter& e = emitters[i];
  const bool directional = emitters.is_directional(i);
  square = directional ? u_position : u_direction;
  const float density = resolution(i) > 0 ? warp(histograms_[i], square) : 1;
  if (!e.sample_emission(directional ? square : u_position, directional ? u_direction : square, out)) return false;
  (directional ? out.pdf_position_a : out.pdf_direction_w) *= density;
  out.flux *= 1 / density;
  return true;
}

float EmissionGuide::factor(const EmitterSet& emitters, size_t i, const Vec3& p, uint32_t primitive,
                            const Vec3& direction) const {
  Vec2 square;
  return resolution(i) > 0 && emitters[i].emission_square(p, primitive, direction, square) ? density(i, square) : 1;
}

void EmissionGuide::apply(const EmitterSet& emitters, size_t i, const Vec3& direction, DirectSample& sample) const {
  const float f = factor(emitters, i, sample.p, sample.primitive, direction);
  (emitters.is_directional(i) ? sample.pdf_position_a : sample.pdf_direction_w) *= f;
}

size_t EmissionGuide::histogram_count() const {
  return size_t(std::count_if(histograms_.begin(), histograms_.end(), [](const Histogram& h) { return h.n > 0; }));
}

size_t EmissionGuide::bytes() const {
  return histograms_.capacity() * sizeof(Histogram) + cumulative_.capacity() * sizeof(float) +
         (choice_.size() + 1) * sizeof(double);
}

}  // namespace ups
