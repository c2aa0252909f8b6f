// See isolines.h. Marching squares on a mesh finer than the lattice, so that the lines follow MapField::between.
#include "report/isolines.h"

#include <algorithm>
#include <unordered_map>

#include "report/profile_plot.h"

namespace ups::report {
namespace {

constexpr uint32_t wanted_side = 240, finest = 12;  // nodes along the longer side; squares a cell

// Values at the nodes of a mesh with `fine` squares a cell.
class Mesh {
 public:
  explicit Mesh(const MapField& field) : lattice_(*field.lattice()) {
    const uint32_t longer = std::max(lattice_.columns, lattice_.rows);
    // Even: nodes lie on the meters, too, or a single one that is less or more has no line.
    fine_ = std::clamp(wanted_side / std::max(longer, 1u) & ~1u, 2u, finest);
    columns_ = lattice_.columns * fine_, rows_ = lattice_.rows * fine_;
    nodes_.resize(size_t(columns_ + 1) * (rows_ + 1));
    for (uint32_t j = 0; j <= rows_; ++j)
      for (uint32_t i = 0; i <= columns_; ++i) nodes_[node(i, j)] = value(field, i, j);
  }

  uint32_t columns() const { return columns_; }
  uint32_t rows() const { return rows_; }
  size_t node(uint32_t i, uint32_t j) const { return size_t(j) * (columns_ + 1) + i; }
  double operator[](size_t n) const { return nodes_[n]; }
  bool has_square(uint32_t i, uint32_t j) const { return lattice_.at(i / fine_, j / fine_) != Lattice::none; }
  Place place(size_t n) const {
    return {lattice_.corner.x + lattice_.step_x * double(n % (columns_ + 1)) / fine_,
            lattice_.corner.y + lattice_.step_y * double(n / (columns_ + 1)) / fine_};
  }

 private:
  // Of any cell that it belongs to.
  double value(const MapField& field, uint32_t i, uint32_t j) const {
    const double x = double(i) / fine_, y = double(j) / fine_;
    for (const int64_t r : {int64_t(j) / fine_, (int64_t(j) - 1) / int64_t(fine_)})
      for (const int64_t c : {int64_t(i) / fine_, (int64_t(i) - 1) / int64_t(fine_)})
        if (const double v = field.between(x, y, c, r); !std::isnan(v)) return v;
    return NAN;
  }

  const Lattice& lattice_;
  uint32_t fine_ = 1, columns_ = 0, rows_ = 0;
  std::vector<double> nodes_;
};

// Where one level crosses edges of the mesh, and which crossings a square joins.
class Tracer {
 public:
  Tracer(const Mesh& mesh, double level) : mesh_(mesh), level_(level) {
    for (uint32_t j = 0; j < mesh.rows(); ++j)
      for (uint32_t i = 0; i < mesh.columns(); ++i)
        if (mesh.has_square(i, j)) add_square(i, j);
  }

  void lines(std::vector<Isoline>& out) {
    std::vector<char> used(crossings_.size(), 0);
    for (const bool open : {true, false}) {  // those with ends from an end
      for (size_t c = 0; c < crossings_.size(); ++c) {
        if (used[c] || (open && crossings_[c].second_next != none)) continue;
        Isoline line{level_, {}};
        size_t at = c, before = none;
        while (at != none && !used[at]) {
          used[at] = 1;
          line.points.push_back(crossings_[at].place);
          const size_t next = crossings_[at].next == before ? crossings_[at].second_next : crossings_[at].next;
          before = at;
          at = next;
        }
        if (at == c && line.points.size() > 2) line.points.push_back(line.points.front());
        if (line.points.size() > 1) out.push_back(std::move(line));
      }
    }
  }

 private:
  static constexpr size_t none = size_t(-1);
  struct Crossing {
    Place place;
    size_t next = none, second_next = none;
  };

  void add_square(uint32_t i, uint32_t j) {
    const size_t n[4] = {mesh_.node(i, j), mesh_.node(i + 1, j), mesh_.node(i + 1, j + 1), mesh_.node(i, j + 1)};
    size_t found[4];
    int count = 0;
    for (int k = 0; k < 4; ++k) {
      if (std::isnan(mesh_[n[k]])) return;
      if ((mesh_[n[k]] >= level_) != (mesh_[n[(k + 1) % 4]] >= level_)) found[count++] = crossing(n[k], n[(k + 1) % 4]);
    }
    if (count == 2) return join(found[0], found[1]);
    if (count != 4) return;
    // A saddle: the mean decides which corners hang together. Crossing k lies between the corners k and k + 1.
    const double mean = 0.25 * (mesh_[n[0]] + mesh_[n[1]] + mesh_[n[2]] + mesh_[n[3]]);
    const bool around_first = (mean >= level_) != (mesh_[n[0]] >= level_);
    join(found[0], found[around_first ? 3 : 1]);
    join(found[2], found[around_first ? 1 : 3]);
  }

  size_t crossing(size_t a, size_t b) {
    if (a > b) std::swap(a, b);
    const uint64_t key = uint64_t(a) * 2 + (b == a + 1 ? 0 : 1);
    const auto [place, is_new] = by_edge_.try_emplace(key, crossings_.size());
    if (is_new) {
      const double t = (level_ - mesh_[a]) / (mesh_[b] - mesh_[a]);
      const Place from = mesh_.place(a), to = mesh_.place(b);
      crossings_.push_back({{from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t}});
    }
    return place->second;
  }

  void join(size_t a, size_t b) {
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}})
      (crossings_[from].next == none ? crossings_[from].next : crossings_[from].second_next) = to;
  }

  const Mesh& mesh_;
  double level_;
  std::vector<Crossing> crossings_;
  std::unordered_map<uint64_t, size_t> by_edge_;
};

}  // namespace

std::vector<double> isoline_levels(double low, double high, MapScale scale) {
  constexpr double most = 10, slack = 1e-9;
  std::vector<double> levels;
  if (!(high > low)) return levels;
  if (scale == MapScale::linear) {
    const double step = round_step((high - low) / most);
    for (double k = std::ceil(low / step - slack); k * step <= high * (1 + slack); ++k)
      if (k * step > 0) levels.push_back(k * step);
    return levels;
  }
  if (!(low > 0)) return levels;
  const std::vector<std::vector<double>> series = {{1, 1.5, 2, 3, 5, 7.5}, {1, 2, 3, 5}, {1, 2, 5}, {1, 3}, {1}};
  for (const std::vector<double>& steps : series) {
    levels.clear();
    for (double power = std::floor(std::log10(low)); power <= std::log10(high) + slack; ++power)
      for (const double step : steps)
        if (const double l = step * std::pow(10.0, power); l >= low * (1 - slack) && l <= high * (1 + slack))
          levels.push_back(l);
    if (double(levels.size()) <= most + 3) break;
  }
  return levels;
}

MapData calmed(const MapData& image) {
  constexpr uint32_t most = 96;  // blocks along the longer side
  const uint32_t block = std::max(1u, (std::max(image.columns, image.rows) + most - 1) / most);
  if (block == 1 && !image.of_camera) return image;  // a pixel is a meter
  const uint32_t columns = std::max(1u, image.columns / block), rows = std::max(1u, image.rows / block);
  std::vector<double> medians;
  for (uint32_t r = 0; r < rows; ++r) {
    for (uint32_t c = 0; c < columns; ++c) {
      std::vector<double> values;
      for (uint32_t y = r * block; y < std::min((r + 1) * block, image.rows); ++y)
        for (uint32_t x = c * block; x < std::min((c + 1) * block, image.columns); ++x)
          if (const MapValue& v = image.values[size_t(y) * image.columns + x]; is_known(v)) values.push_back(v.value);
      std::nth_element(values.begin(), values.begin() + ptrdiff_t(values.size() / 2), values.end());
      medians.push_back(values.empty() ? -1 : values[values.size() / 2]);
    }
  }
  MapData calm;
  calm.is_image = true;
  calm.columns = columns, calm.rows = rows;
  for (uint32_t r = 0; r < rows; ++r) {
    for (uint32_t c = 0; c < columns; ++c) {
      double sum = 0, weights = 0;  // binomial, 3 x 3
      for (uint32_t y = r - (r > 0); y <= std::min(r + 1, rows - 1); ++y)
        for (uint32_t x = c - (c > 0); x <= std::min(c + 1, columns - 1); ++x) {
          const double weight = (x == c ? 2 : 1) * (y == r ? 2 : 1), median = medians[size_t(y) * columns + x];
          if (median >= 0) sum += weight * median, weights += weight;
        }
      calm.values.push_back({{(c + 0.5) * block, (r + 0.5) * block}, weights > 0 ? sum / weights : -1, -1});
    }
  }
  return calm;
}

std::vector<Isoline> isolines_of(const MapField& field, const std::vector<double>& levels) {
  std::vector<Isoline> lines;
  if (!field.lattice()) return lines;
  const Mesh mesh(field);
  for (const double level : levels) Tracer(mesh, level).lines(lines);
  return lines;
}

}  // namespace ups::report
