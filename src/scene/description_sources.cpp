// See description.h: lights and luminaires.
#include <cmath>
#include <type_traits>

#include "scene/description.h"
#include "scene/read.h"

namespace ups {
namespace {

void copy_rgb(const Rgb& from, float (&to)[3]) { to[0] = from.r, to[1] = from.g, to[2] = from.b; }

}  // namespace

void Description::set_maintenance_factor(double factor) {
  check::require(std::isfinite(factor) && factor > 0 && factor <= 1,
                 "maintenance_factor is " + check::text(factor) + "; it must be above 0 and at most 1");
  maintenance_factor_ = factor;
  ++revision_;
}

SourceDescription Description::read(const ups_light_desc& d) const {
  check::enumeration(d.kind, UPS_LIGHT_DIRECTIONAL, "kind", "UPS_LIGHT_*");
  check::transform(d.to_world, "to_world");
  check::colour(d.intensity_rgb, 0, INFINITY, "intensity_rgb");
  if (d.kind == UPS_LIGHT_SPOT) {
    check::range(double(d.outer_cone_rad), 0, double(float(0.5 * 3.14159265358979)), "outer_cone_rad");
    check::require(d.inner_cone_rad >= 0 && d.inner_cone_rad < d.outer_cone_rad,
                   "inner_cone_rad is " + check::text(double(d.inner_cone_rad)) +
                       "; it must be at least 0 and less than outer_cone_rad, " +
                       check::text(double(d.outer_cone_rad)));
  }
  const LightDescription light{d.kind, to_affine(d.to_world), to_rgb(d.intensity_rgb), d.inner_cone_rad,
                               d.outer_cone_rad};
  return {light, 1.0f, d.group};
}

ups_luminaire_id Description::add_light(const ups_light_desc& d) { return {add(sources_, read(d))}; }

template <class Kind>
const Kind& Description::source_of(ups_luminaire_id id) const {
  const auto* kind = std::get_if<Kind>(&sources_.get(id.v, "luminaire").kind);
  constexpr bool wants_light = std::is_same_v<Kind, LightDescription>;
  check::require(kind, "luminaire id " + std::to_string(number_of(id.v)) +
                           (wants_light ? " is a luminaire, not a light" : " is a light, not a luminaire"));
  return *kind;
}

void Description::set_light(ups_luminaire_id id, const ups_light_desc& d) {
  source_of<LightDescription>(id);
  SourceDescription light = read(d);
  light.dimming = dimming(id);
  set(sources_, id.v, std::move(light), "luminaire");
}

SourceDescription Description::read(const ups_luminaire_desc& d,
                                    std::shared_ptr<const photometry::Photometry> profile) const {
  check::flag(d.use_opening, "use_opening");
  check::pointer(profile.get(), "profile");
  check::transform(d.to_world, "to_world");
  check::colour(d.color_rgb, 0, INFINITY, "color_rgb");
  const float y = luminance(to_rgb(d.color_rgb));
  check::require(y > 0 && std::isfinite(y),
                 "color_rgb is black; it must have a luminance above 0 (flux sets how much light)");
  check::finite(double(d.flux_lm), "flux_lm");
  check::at_least(double(d.dimming), 0, "dimming");
  check::at_least(double(d.intensity_scale), 0, "intensity_scale");
  check::require(
      d.flux_lm <= 0 || profile->distribution.band_flux_lm() > 0,
      "flux_lm is " + check::text(double(d.flux_lm)) + ", but the profile emits nothing that could be scaled to it");
  // One that is normalised stays as it is: what is read and set again is the same.
  const Rgb color = std::abs(y - 1) <= 1e-6f ? to_rgb(d.color_rgb) : to_rgb(d.color_rgb) / y;
  LuminaireDescription luminaire{std::move(profile), d.use_opening == 1, to_affine(d.to_world), color, d.flux_lm,
                                 d.intensity_scale};
  check_reserved(d.reserved);
  return {std::move(luminaire), d.dimming, d.group};
}

ups_luminaire_id Description::add_luminaire(const ups_luminaire_desc& d,
                                            std::shared_ptr<const photometry::Photometry> profile) {
  return {add(sources_, read(d, std::move(profile)))};
}

void Description::set_luminaire(ups_luminaire_id id, const ups_luminaire_desc& d,
                                std::shared_ptr<const photometry::Photometry> profile) {
  const LuminaireDescription& old = source_of<LuminaireDescription>(id);
  set(sources_, id.v, read(d, profile ? std::move(profile) : old.profile), "luminaire");
}

void Description::set_luminaire_transform(ups_luminaire_id id, const double (&to_world)[12]) {
  SourceDescription source = sources_.get(id.v, "luminaire");
  check::transform(to_world, "to_world");
  std::visit([&](auto& kind) { kind.to_world = to_affine(to_world); }, source.kind);
  set(sources_, id.v, std::move(source), "luminaire");
}

void Description::set_dimming(ups_luminaire_id id, float dimming) {
  SourceDescription source = sources_.get(id.v, "luminaire");
  check::at_least(double(dimming), 0, "dimming");
  source.dimming = dimming;
  set(sources_, id.v, std::move(source), "luminaire");
}

ups_light_desc Description::light(ups_luminaire_id id) const {
  const LightDescription& light = source_of<LightDescription>(id);
  ups_light_desc d{};
  d.kind = light.kind;
  copy_transform(light.to_world, d.to_world);
  copy_rgb(light.intensity, d.intensity_rgb);
  d.inner_cone_rad = light.inner_cone_rad, d.outer_cone_rad = light.outer_cone_rad;
  d.group = sources_.get(id.v, "luminaire").group;
  return d;
}

ups_luminaire_desc Description::luminaire(ups_luminaire_id id) const {
  const LuminaireDescription& luminaire = source_of<LuminaireDescription>(id);
  const SourceDescription& source = sources_.get(id.v, "luminaire");
  ups_luminaire_desc d{};
  d.use_opening = luminaire.use_opening;
  copy_transform(luminaire.to_world, d.to_world);
  copy_rgb(luminaire.color, d.color_rgb);
  d.flux_lm = luminaire.flux_lm, d.intensity_scale = luminaire.intensity_scale;
  d.dimming = source.dimming, d.group = source.group;
  return d;
}

const std::shared_ptr<const photometry::Photometry>& Description::profile(ups_luminaire_id id) const {
  return source_of<LuminaireDescription>(id).profile;
}

}  // namespace ups
