// UPS for C++17: luminous intensity distributions, ups_photometry.h and what ups_glare.h finds of a luminaire.
// See ups.hpp.
#ifndef UPS_HPP_PROFILE_HPP
#define UPS_HPP_PROFILE_HPP

#include "base.hpp"

namespace ups {
inline namespace v0_1 {

struct ProfileDesc : ups_profile_desc {
  ProfileDesc() noexcept { ups_profile_desc_init(this, sizeof(ups_profile_desc)); }
  // A table: c_deg.size() * gamma_deg.size() intensities, cd, gamma fastest.
  ProfileDesc(Span<const float> c_planes_deg, Span<const float> gammas_deg, Span<const float> intensities_cd)
      : ProfileDesc() {
    detail::expect(intensities_cd.size(), c_planes_deg.size() * gammas_deg.size(), "intensities_cd");
    c_count = detail::count(c_planes_deg.size(), 1, "c_planes_deg");
    gamma_count = detail::count(gammas_deg.size(), 1, "gammas_deg");
    c_deg = c_planes_deg.data();
    gamma_deg = gammas_deg.data();
    intensity_cd = intensities_cd.data();
  }
};

struct ProfileParseDesc : ups_profile_parse_desc {
  ProfileParseDesc() noexcept { ups_profile_parse_desc_init(this, sizeof(ups_profile_parse_desc)); }
};

// One distribution: immutable, any thread. Scenes that took it keep what they need.
class Profile : public Handle<ups_profile> {
 public:
  using Handle::Handle;
  Profile(const Context &context, const ProfileDesc &desc)
      : Handle(detail::value<ups_profile *>(ups_profile_create, context.get(), &desc)) {}
  // Of a photometric file's bytes: any array of elements of one byte.
  template <typename Byte>
  static Profile parse(const Context &context, const Byte &bytes, ups_profile_format format = UPS_PROFILE_AUTO) {
    static_assert(sizeof(*std::data(bytes)) == 1, "bytes: an array of char, unsigned char or std::byte");
    return Profile(detail::value<ups_profile *>(ups_profile_parse, context.get(),
                                                static_cast<const void *>(std::data(bytes)), std::size(bytes), format));
  }
  static Profile parse_with(const Context &context, const ProfileParseDesc &desc) {
    return Profile(detail::value<ups_profile *>(ups_profile_parse_with, context.get(), &desc));
  }
  Profile with_keyword(const char *name, const char *keyword) const {
    return Profile(detail::value<ups_profile *>(ups_profile_with_keyword, get(), name, keyword));
  }

  // The file's text.
  std::string write(ups_profile_format format) const { return detail::text(ups_profile_write, get(), format); }
  std::string get_write_warnings(ups_profile_format format) const {
    return detail::text(ups_profile_get_write_warnings, get(), format);
  }
  ups_profile_info get_info() const { return detail::sized<ups_profile_info>(ups_profile_get_info, get()); }
  std::string get_text(ups_profile_text topic) const { return detail::text(ups_profile_get_text, get(), topic); }
  std::string get_keyword(const char *name) const { return detail::text(ups_profile_get_keyword, get(), name); }
  std::vector<ups_profile_lamp_set> lamp_sets() const {
    std::vector<ups_profile_lamp_set> out(get_info().lamp_set_count);
    for (std::uint32_t i = 0; i < out.size(); ++i)
      out[i] = detail::sized<ups_profile_lamp_set>(ups_profile_get_lamp_set, get(), i);
    return out;
  }

  // cd, in directions of the profile's frame: 3 floats each, any length > 0.
  std::vector<float> eval(Span<const float> directions) const { return seen(ups_profile_eval, directions); }
  // cd/m^2 of the luminous opening, seen from such directions.
  std::vector<float> get_luminance(Span<const float> directions) const {
    return seen(ups_profile_get_luminance, directions);
  }
  // lm between ascending angles: one value less than there are angles.
  std::vector<double> get_zonal_flux(Span<const float> gamma_deg) const {
    std::vector<double> out(gamma_deg.empty() ? 0 : gamma_deg.size() - 1);
    check(ups_profile_get_zonal_flux(get(), gamma_deg.data(), gamma_deg.size(), out.data()));
    return out;
  }
  ups_profile_beam get_beam(float c_deg, float fraction) const {
    return detail::sized<ups_profile_beam>(ups_profile_get_beam, get(), c_deg, fraction);
  }

  ups_ugr_table get_ugr_table() const { return detail::sized<ups_ugr_table>(ups_profile_get_ugr_table, get()); }
  ups_data_sheet get_data_sheet(float front_c_deg = 0) const {
    return detail::sized<ups_data_sheet>(ups_profile_get_data_sheet, get(), front_c_deg);
  }
  ups_utilisation_table get_utilisation() const {
    return detail::sized<ups_utilisation_table>(ups_profile_get_utilisation, get());
  }

 private:
  template <typename Function>
  std::vector<float> seen(Function function, Span<const float> directions) const {
    std::vector<float> out(detail::count(directions.size(), 3, "directions"));
    check(function(get(), directions.data(), out.size(), out.data()));
    return out;
  }
};

}  // namespace v0_1
}  // namespace ups

#endif
