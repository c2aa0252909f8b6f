// See tm33_table.h.
#include "photometry/tm33_table.h"

#include <algorithm>

#include "photometry/ies_planes.h"
#include "photometry/text_reader.h"

namespace photometry {
namespace {

constexpr double beyond = 1e-6;  // degrees past a table's end, where it is dark

std::string direction_text(double h, double v) { return "the direction h = " + shown(h) + ", v = " + shown(v); }

// Of a sorted plane, the value at v, or null.
const DirectedValue* find(const DirectedValue* begin, const DirectedValue* end, double v) {
  const DirectedValue* at =
      std::lower_bound(begin, end, v, [](const DirectedValue& a, double wanted) { return a.v_deg < wanted; });
  return at != end && at->v_deg == v ? at : nullptr;
}

std::vector<double> sorted_angles(const std::vector<DirectedValue>& values, double DirectedValue::*angle) {
  std::vector<double> all;
  for (const DirectedValue& value : values) all.push_back(value.*angle);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void merge_twins(std::vector<DirectedValue>& values, std::vector<std::string>& warnings) {
  size_t twins = 0, twin_line = 0, kept = 0;
  for (size_t i = 0; i < values.size(); ++i) {
    const DirectedValue& value = values[i];
    if (kept > 0 && values[kept - 1].h_deg == value.h_deg && values[kept - 1].v_deg == value.v_deg) {
      if (values[kept - 1].value != value.value)
        fail_at(value.line, direction_text(value.h_deg, value.v_deg) + " has the intensity " + shown(value.value) +
                                " here and " + shown(values[kept - 1].value) + " in line " +
                                std::to_string(values[kept - 1].line));
      if (twins++ == 0) twin_line = value.line;
    } else {
      values[kept++] = value;
    }
  }
  values.resize(kept);
  if (twins > 0) warnings.push_back(at_line(twin_line, std::to_string(twins) + " directions are stated twice"));
}

// Bilinear, 0 outside the rows.
double value_at(const Distribution& d, double c_deg, double gamma_deg) {
  const std::vector<double>&c = d.c_deg(), &g = d.gamma_deg();
  if (gamma_deg < g.front() || gamma_deg > g.back()) return 0;
  const size_t j = size_t(std::upper_bound(g.begin() + 1, g.end() - 1, gamma_deg) - g.begin()) - 1;
  const double t = (gamma_deg - g[j]) / (g[j + 1] - g[j]);
  const size_t i = c.size() == 1 ? 0 : size_t(std::upper_bound(c.begin() + 1, c.end(), c_deg) - c.begin()) - 1;
  const size_t next = (i + 1) % c.size();
  const double width = next > i ? c[next] - c[i] : 360 - c[i] + c[0], s = c.size() == 1 ? 0 : (c_deg - c[i]) / width;
  return (1 - s) * ((1 - t) * d.at(i, j) + t * d.at(i, j + 1)) + s * ((1 - t) * d.at(next, j) + t * d.at(next, j + 1));
}

void sort_unique(std::vector<double>& angles) {
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
}

// No plane 360 is asked for: the first closes a circle whose last step is no wider than the others are.
void close_circle(std::vector<Plane>& planes) {
  const double first = planes.front().c_deg, last = planes.back().c_deg;
  if (planes.size() < 3 || first != 0 || last <= 180 || last >= 360) return;
  double widest = 0;
  for (size_t i = 1; i < planes.size(); ++i) widest = std::max(widest, planes[i].c_deg - planes[i - 1].c_deg);
  if (360 - last <= widest + 1e-6) planes.push_back({360, planes.front().intensity_cd});
}

}  // namespace

Distribution table_of(std::vector<DirectedValue> values, PhotometricType type, size_t line, Symmetry& symmetry,
                      std::vector<std::string>& warnings) {
  std::stable_sort(values.begin(), values.end(), [](const DirectedValue& a, const DirectedValue& b) {
    return a.h_deg != b.h_deg ? a.h_deg < b.h_deg : a.v_deg < b.v_deg;
  });
  merge_twins(values, warnings);
  IesTable table{type, sorted_angles(values, &DirectedValue::v_deg), {}};
  if (table.vertical_deg.size() < 2) fail_at(line, "there are fewer than 2 angles v; a table needs at least 2");
  const std::vector<double> h_deg = sorted_angles(values, &DirectedValue::h_deg);
  if (h_deg.size() > Distribution::max_values / table.vertical_deg.size())
    fail_at(line, std::to_string(h_deg.size()) + " x " + std::to_string(table.vertical_deg.size()) +
                      " directions are too many; at most 4000000 are read");
  const DirectedValue *begin = values.data(), *end = begin + values.size(), *at = begin;
  const auto any_at = [&](double v) {
    return std::find_if(begin, end, [&](const DirectedValue& x) { return x.v_deg == v; });
  };
  const DirectedValue *nadir = any_at(0), *zenith = any_at(180);
  for (double h : h_deg) {
    const DirectedValue* next = std::find_if(at, end, [&](const DirectedValue& x) { return x.h_deg != h; });
    table.planes.push_back({h, {}});
    for (double v : table.vertical_deg) {
      const DirectedValue* found = find(at, next, v);
      if (!found && type == PhotometricType::c && (v == 0 || v == 180)) found = v == 0 ? nadir : zenith;
      if (!found)
        fail_at(line, direction_text(h, v) + " is missing; every h must have the same " +
                          std::to_string(table.vertical_deg.size()) + " angles v");
      table.planes.back().intensity_cd.push_back(found->value);
    }
    at = next;
  }
  if (type == PhotometricType::c) close_circle(table.planes);
  // Part of the circle may be from 90 to 270, as in LM-63-1995.
  return arrange_ies_table(std::move(table), IesEdition::y1995, {line, line}, symmetry, warnings);
}

Distribution sum_of(const std::vector<Distribution>& parts) {
  std::vector<double> c, gamma;
  for (const Distribution& d : parts) {
    c.insert(c.end(), d.c_deg().begin(), d.c_deg().end());
    gamma.insert(gamma.end(), d.gamma_deg().begin(), d.gamma_deg().end());
  }
  sort_unique(gamma);
  const double first = gamma.front(), last = gamma.back();
  for (const Distribution& d : parts) {  // where one ends and another goes on
    if (d.gamma_deg().front() > first) gamma.push_back(d.gamma_deg().front() - beyond);
    if (d.gamma_deg().back() < last) gamma.push_back(d.gamma_deg().back() + beyond);
  }
  sort_unique(gamma);
  c.push_back(0);
  sort_unique(c);
  constexpr double most_looked_up = 1e8;  // some seconds
  if (c.size() > Distribution::max_values / gamma.size() ||
      double(c.size() * gamma.size()) * double(parts.size()) > most_looked_up)
    throw std::invalid_argument("the sum of the " + std::to_string(parts.size()) +
                                " emitters has too many directions, " + std::to_string(c.size()) + " angles h by " +
                                std::to_string(gamma.size()) + " angles v");
  std::vector<double> table;
  for (double ci : c)
    for (double g : gamma) {
      double sum = 0;
      for (const Distribution& d : parts) sum += value_at(d, ci, g);
      table.push_back(sum);
    }
  return Distribution(std::move(c), std::move(gamma), std::move(table));
}

}  // namespace photometry
