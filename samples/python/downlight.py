#!/usr/bin/env python3
"""The downlight of samples/c measured: its light output ratio, its beam angle, and its distribution as an IES file.

    UPS_LIBRARY=build/release/src/api PYTHONPATH=bindings/python samples/python/downlight.py [file.ies] [iterations]
"""
import sys

import numpy as np
import ups


def make_downlight(context):
    """The fixture's origin is the COB; light goes along local -Z."""
    downlight = ups.Fixture(context)
    downlight.add_emitter(radius_m=0.0045, flux_lm=1000)
    # A paraboloid with its focus in the COB, whose plane the inner radius, twice the focal length, lies in.
    downlight.add_reflector(focal_length_m=0.004, inner_radius_m=0.008, aperture_radius_m=0.025,
                            finish=ups.Finish.SEMI_SPECULAR_ALUMINIUM)
    return downlight


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else "downlight.ies"
    iterations = int(sys.argv[2]) if len(sys.argv) > 2 else 64
    context = ups.Context()
    scene = ups.Scene(context)
    scene.add_fixture(make_downlight(context))
    sensor = scene.add_goniometer(c_deg=[0], gamma_deg=np.arange(0, 181, 2), symmetry=ups.ProfileSymmetry.AXIAL,
                                  opening_shape=ups.OpeningShape.DISC, opening_m=(0.05, 0.05, 0))
    scene.commit()
    result = scene.render(iteration_count=iterations, seed=7)

    measured, nadir = result.goniometer_info(sensor), result.goniometer(sensor)[0, 0]
    ratio, error = measured.light_output_ratio, measured.light_output_ratio_standard_error
    print(f"light output ratio {ratio:.2%}, standard error {error:.3%}")
    print(f"{nadir['intensity_cd']:.0f} cd ± {nadir['error_bound_cd']:.0f} at the nadir")
    profile = result.goniometer_profile(sensor)
    print(f"beam angle {profile.beam().angle_deg:.1f}°, field angle {profile.beam(fraction=0.1).angle_deg:.1f}°")
    with open(path, "wb") as file:
        file.write(profile.write(ups.ProfileFormat.IES_LM63))

    with open(path, "rb") as file:
        again = ups.Profile.parse(context, file.read())
    print(f"{path}: {again.format}, {again.info.flux_lm:.1f} lm")
    # The reflector keeps 14 % of the two thirds that meet it, more where light meets it twice; the COB what comes back.
    if not 0.8 < ratio < 1 or abs(again.info.interpolated_flux_lm / measured.flux_lm - 1) > 1e-3:
        sys.exit("the downlight does not give what it should")


if __name__ == "__main__":
    main()
