// ups_glare.h: ratings at observers, tables and data sheets of profiles.
#include <algorithm>
#include <cmath>

#include "api/desc.h"
#include "api/render_handles.h"
#include "photometry/data_sheet.h"
#include "photometry/metrics.h"
#include "photometry/ugr.h"
#include "photometry/ugr_table.h"
#include "scene/check.h"

using namespace ups;
using namespace ups::api;

namespace {

static_assert(int(photometry::PositionIndex::guth) == UPS_POSITION_INDEX_GUTH);

void put(const photometry::Reflectances& rho, float* out) {
  out[0] = float(rho.ceiling), out[1] = float(rho.walls), out[2] = float(rho.floor);
}

ups_ugr_table table_of(const photometry::Photometry& data) {
  using photometry::UgrTable;
  static_assert(std::size(ups_ugr_table{}.crosswise) == size_t(UgrTable::rooms) * UgrTable::reflectance_sets);
  const UgrTable table = photometry::ugr_table(data);
  ups_ugr_table out{};
  out.lamp_flux_lm = float(table.lamp_flux_lm);
  for (int k = 0; k < UgrTable::reflectance_sets; ++k) put(UgrTable::reflectances[k], out.reflectances + 3 * k);
  for (int r = 0; r < UgrTable::rooms; ++r) {
    out.room_across_h[r] = float(UgrTable::shapes[r].x);
    out.room_along_h[r] = float(UgrTable::shapes[r].y);
    for (int k = 0; k < UgrTable::reflectance_sets; ++k) {
      out.crosswise[r * UgrTable::reflectance_sets + k] = float(table.ugr[0][r][k]);
      out.endwise[r * UgrTable::reflectance_sets + k] = float(table.ugr[1][r][k]);
    }
  }
  return out;
}

ups_data_sheet sheet_of(const photometry::Photometry& data, double front_c_deg) {
  ups_data_sheet out{};
  const auto copy = [](const auto& from, auto& to) { std::copy(std::begin(from), std::end(from), std::begin(to)); };
  copy(photometry::flux_code(data).n, out.flux_code);
  const photometry::HighLuminance high = photometry::high_luminance(data);
  copy(high.at_cd_m2, out.luminance_cd_m2);
  out.highest_luminance_cd_m2 = float(high.highest_cd_m2);
  out.highest_luminance_c_deg = float(high.c_deg);
  out.highest_luminance_gamma_deg = float(high.highest_gamma_deg);
  const photometry::SpacingCriterion sc = photometry::spacing_criterion(data);
  out.spacing_criterion[0] = float(sc.along_c0);
  out.spacing_criterion[1] = float(sc.along_c90);
  out.spacing_criterion[2] = float(sc.diagonal);
  out.nema_horizontal = photometry::nema_type(photometry::beam_of(data, 90, 0.1).angle_deg);
  out.nema_vertical = photometry::nema_type(photometry::beam_of(data, 0, 0.1).angle_deg);
  const photometry::BugRating bug = photometry::bug_rating(data, front_c_deg);
  copy(bug.front_lm, out.front_lm);
  copy(bug.back_lm, out.back_lm);
  copy(bug.up_lm, out.up_lm);
  out.backlight_rating = bug.backlight;
  out.uplight_rating = bug.uplight;
  out.glare_rating = bug.glare;
  out.bug_type_v = bug.type_v;
  return out;
}

ups_utilisation_table utilisation_of(const photometry::Photometry& data) {
  using photometry::UtilisationFactors;
  constexpr int sets = UtilisationFactors::reflectance_sets;
  static_assert(std::size(ups_utilisation_table{}.factors) == size_t(UtilisationFactors::rooms) * sets);
  const UtilisationFactors factors = photometry::utilisation_factors(data);
  ups_utilisation_table out{};
  for (int k = 0; k < sets; ++k) put(UtilisationFactors::reflectances[k], out.reflectances + 3 * k);
  for (int r = 0; r < UtilisationFactors::rooms; ++r) {
    out.room_index[r] = float(UtilisationFactors::room_index[r]);
    for (int k = 0; k < sets; ++k) out.factors[r * sets + k] = float(factors.factor[r][k]);
  }
  return out;
}

size_t observer_index(const RenderResult& r, ups_sensor_id observer) {
  return index_of(r, r.scene->observer_ids, observer, "rated eye (an observer)");
}

bool is_large(const SeenSource& s) { return s.largest_sr > photometry::large_source_sr; }

uint32_t flags_of(const SeenGlare& glare) {
  uint32_t flags = glare.sources.empty() ? UPS_OBSERVER_NO_SOURCE : 0;
  for (const SeenSource& s : glare.sources) {
    if (is_large(s)) flags |= UPS_OBSERVER_LARGE_SOURCE;
    if (s.glare.luminance_cd_m2 < 0) flags |= UPS_OBSERVER_POINT_SOURCE;
  }
  if (glare.has_fixture) flags |= UPS_OBSERVER_FIXTURE;
  if (glare.has_covered) flags |= UPS_OBSERVER_COVERED_SOURCE;
  return flags | (glare.has_unrated ? uint32_t(UPS_OBSERVER_UNRATED_SOURCE) : 0);
}

// Of what is in view a part counts as background.
bool lacks_light(const SeenGlare& glare) { return glare.has_fixture || glare.has_covered; }

// dUGR = 8 / ln 10 (dS / S - dL_b / L_b); the ends of the interval by the ends of both and by what rays may have
// missed.
void rate(const SeenGlare& glare, ups_observer_reading& out) {
  const double background = out.background_cd_m2, error = out.background_standard_error_cd_m2,
               bound = out.background_error_bound_cd_m2;
  out.ugr = float(photometry::ugr(glare.sum, background));
  const double hidden = glare.sum_error / glare.sum, slope = 8 / std::log(10.0);
  if (error >= 0) out.ugr_standard_error = float(slope * std::hypot(error / background, hidden));
  if (!(bound >= 0)) return;
  const auto away = [&](double end, double missed) {
    return std::hypot(8 * std::log10(end), slope * 1.96 * hidden, 8 * std::log10(missed));
  };
  out.ugr_low = out.ugr - float(away((background + bound) / background, 1 - glare.hidden / glare.sum));
  if (bound < background && !lacks_light(glare))
    out.ugr_high = out.ugr + float(away(background / (background - bound), 1 + glare.unseen / glare.sum));
}

// No ray has seen a source, but one is there: the most that it may rate.
void rate_unseen(const SeenGlare& glare, ups_observer_reading& out) {
  const double bound = out.background_error_bound_cd_m2, least = out.background_cd_m2 - bound;
  const bool known =
      !(out.flags & UPS_OBSERVER_NO_BACKGROUND) && bound >= 0 && least > 0 && !lacks_light(glare);
  out.ugr_high = known ? float(photometry::ugr(glare.unseen, least)) : INFINITY;
}

// d(2.55 (1 + Ed / 220) / (1 + Ed / Ei)) has the sign of Ei - 220 for Ed: the ends are among the corners of both errors.
void rate_large(const ups_meter_part_reading& direct, double coverage, ups_observer_reading& out) {
  out.ceiling_coverage = float(coverage);
  const double background = double(out.background_cd_m2), ed = double(direct.illuminance_lx);
  const auto rating = [&](double ugr, double direct_lx, double background_cd_m2) {
    return float(photometry::great_glare_rating(ugr, coverage, direct_lx, double(pi) * background_cd_m2));
  };
  out.ggr = rating(double(out.ugr), ed, background);
  const double bound = double(out.background_error_bound_cd_m2), direct_bound = double(direct.error_bound_lx);
  if (!(bound >= 0 && direct_bound >= 0)) return;
  const bool ends = out.ugr_high != -1;
  out.ggr_low = INFINITY, out.ggr_high = ends ? -INFINITY : -1;
  for (const double d : {std::max(0.0, ed - direct_bound), ed + direct_bound}) {
    out.ggr_low = std::min(out.ggr_low, rating(double(out.ugr_low), d, background + bound));
    if (ends) out.ggr_high = std::max(out.ggr_high, rating(double(out.ugr_high), d, background - bound));
  }
}

ups_observer_reading reading_of(const RenderResult& r, size_t observer) {
  const SeenGlare& glare = (*r.glare)[observer];
  const MeterSetReading& eye = r.meter_sets[r.scene->observers[observer].meter_set];
  const ups_meter_part_reading& indirect = eye.parts[UPS_LIGHT_PART_INDIRECT][0];
  const auto luminance_of = [](float lx) { return lx >= 0 ? float(double(lx) / double(pi)) : -1; };
  ups_observer_reading out{};
  out.ugr = out.ugr_standard_error = out.ugr_low = out.ugr_high = out.ggr = out.ggr_low = out.ggr_high = -1;
  out.flags = flags_of(glare);
  out.source_count = uint32_t(glare.sources.size());
  out.background_cd_m2 = luminance_of(indirect.illuminance_lx);
  out.background_standard_error_cd_m2 = luminance_of(indirect.standard_error_lx);
  out.background_error_bound_cd_m2 = luminance_of(indirect.error_bound_lx);
  // What is left where all light comes straight is rounding.
  const double least = 1e-6 * double(eye.meters[0].illuminance_lx) / double(pi);
  if (!(double(out.background_cd_m2) > least)) out.flags |= UPS_OBSERVER_NO_BACKGROUND;
  if (out.flags & UPS_OBSERVER_NO_SOURCE && (glare.unseen > 0 || lacks_light(glare))) rate_unseen(glare, out);
  if (out.flags & (UPS_OBSERVER_NO_SOURCE | UPS_OBSERVER_NO_BACKGROUND)) return out;
  rate(glare, out);
  if (glare.ceiling_coverage > 0) rate_large(eye.parts[UPS_LIGHT_PART_DIRECT][0], glare.ceiling_coverage, out);
  return out;
}

ups_glare_source source_of(const RenderResult& r, const SeenGlare& glare, uint32_t index) {
  check::require(index < glare.sources.size(), "index is " + std::to_string(index) + "; the observer's rating has " +
                                                   std::to_string(glare.sources.size()) + " sources");
  const SeenSource& s = glare.sources[index];
  const Source& source = r.scene->sources[r.scene->source_of_emitter[s.emitter]];
  ups_glare_source out{};
  out.kind = source.kind;
  out.id = source.id | r.scene->tag->bits();
  if (s.glare.is_small) out.flags |= UPS_GLARE_FLAG_SMALL;
  if (s.glare.luminance_cd_m2 < 0) out.flags |= UPS_GLARE_FLAG_POINT;
  if (is_large(s)) out.flags |= UPS_GLARE_FLAG_LARGE;
  if (s.visible_share < 1) out.flags |= UPS_GLARE_FLAG_HIDDEN;
  out.luminance_cd_m2 = float(s.glare.luminance_cd_m2);
  out.solid_angle_sr = float(s.glare.solid_angle_sr);
  out.intensity_cd = float(s.glare.intensity_cd);
  out.distance_m = float(s.glare.distance_m);
  out.visible_share = float(s.visible_share);
  out.position_index = float(s.glare.position_index);
  out.share = float(s.term / glare.sum);
  out.direction[0] = s.direction.x, out.direction[1] = s.direction.y, out.direction[2] = s.direction.z;
  return out;
}

}  // namespace

ups_status ups_glare_get_position_index(ups_position_index kind, const float* directions_xyz, size_t count,
                                        float* index) {
  return guard(__func__, [&] {
    check::enumeration(kind, UPS_POSITION_INDEX_GUTH, "kind", "UPS_POSITION_INDEX_*");
    if (count == 0) return;
    check::pointer(directions_xyz, "directions_xyz");
    check::pointer(index, "index");
    const auto direction = [&](size_t i) {
      return Vec3d(directions_xyz[3 * i], directions_xyz[3 * i + 1], directions_xyz[3 * i + 2]);
    };
    for (size_t i = 0; i < count; ++i)
      if (!(is_finite(direction(i)) && length2(direction(i)) > 0))
        fail_argument("directions_xyz: element " + std::to_string(i) +
                      " is not a direction; it must be finite and not 0");
    for (size_t i = 0; i < count; ++i) {
      const Vec3d d = direction(i);
      index[i] = float(photometry::position_index(photometry::PositionIndex(kind), d.x, d.y, -d.z));
    }
  });
}

ups_status ups_glare_get_ugr(const float* luminance_cd_m2, const float* solid_angle_sr, const float* position_index,
                             size_t count, double background_cd_m2, float* ugr) {
  return guard(__func__, [&] {
    float& out = require(ugr, "ugr");
    if (!std::isfinite(background_cd_m2) || background_cd_m2 <= 0)
      fail_argument("background_cd_m2 is " + check::text(background_cd_m2) + "; it must be above 0 and finite");
    double sum = 0;
    for (size_t i = 0; i < count; ++i) {
      const double l = luminance_cd_m2 ? double(luminance_cd_m2[i]) : -1;
      const double w = solid_angle_sr ? double(solid_angle_sr[i]) : -1;
      const double p = position_index ? double(position_index[i]) : 0;
      if (!(l >= 0 && w >= 0 && p != 0 && std::isfinite(l * w * p)))
        fail_argument("source " + std::to_string(i) +
                      ": luminance and solid angle must be given, finite and >= 0, the position index not 0");
      if (p > 0) sum += l * l * w / (p * p);
    }
    out = sum > 0 ? float(photometry::ugr(sum, background_cd_m2)) : -1;
  });
}

ups_status ups_profile_get_ugr_table(const ups_profile* profile, ups_ugr_table* table) {
  return guard(__func__, [&] { write_info(table, table_of(*require(profile, "profile").data), "table"); });
}

ups_status ups_profile_get_data_sheet(const ups_profile* profile, float front_c_deg, ups_data_sheet* sheet) {
  return guard(__func__, [&] {
    const photometry::Photometry& data = *require(profile, "profile").data;
    check::finite(front_c_deg, "front_c_deg");
    write_info(sheet, sheet_of(data, front_c_deg), "sheet");
  });
}

ups_status ups_profile_get_utilisation(const ups_profile* profile, ups_utilisation_table* table) {
  return guard(__func__, [&] { write_info(table, utilisation_of(*require(profile, "profile").data), "table"); });
}

void ups_observer_desc_init(ups_observer_desc* desc, uint32_t struct_size) {
  ups_observer_desc d{};
  set_identity(d.to_world);
  write_defaults(desc, struct_size, d);
}

ups_status ups_scene_add_observer(ups_scene* scene, const ups_observer_desc* desc, ups_sensor_id* out) {
  return guard(__func__, [&] {
    require(scene, "scene");
    require(out, "out");
    *out = scene->description.add_observer(read_desc(desc, &ups_observer_desc_init));
  });
}

ups_status ups_result_get_observer(const ups_result* result, ups_sensor_id observer, ups_observer_reading* reading) {
  return guard(__func__, [&] {
    const RenderResult& r = data_of(result);
    write_info(reading, reading_of(r, observer_index(r, observer)), "reading");
  });
}

ups_status ups_result_get_glare_source(const ups_result* result, ups_sensor_id observer, uint32_t index,
                                       ups_glare_source* source) {
  return guard(__func__, [&] {
    const RenderResult& r = data_of(result);
    write_info(source, source_of(r, (*r.glare)[observer_index(r, observer)], index), "source");
  });
}
