"""How the tests in Python judge a reading: the rule of expect_lx.h. An error of half a percent is allowed, or four
standard errors where the noise is larger; the noise itself is bounded. Of 16 batches a right program fails a
comparison with probability below P(|t_15| > 4) = 0.12 %, far less where the half percent is larger; at the largest
noise allowed, 0.17 %, an error of 1 % is found in 96 cases of 100, at 0.1 % always. Seeds are fixed."""

TOLERANCE, SIGMAS, QUIET = 0.005, 4, 0.0017


def expect_lx(value, standard_error, expected, what="", largest=QUIET):
    """largest: standard error over what is expected. Of light, flux or a ratio."""
    if not 0 <= standard_error <= largest * expected:
        raise AssertionError(f"{what}: {value} has a standard error of {standard_error}, which is too large or none")
    if not abs(value - expected) <= max(TOLERANCE * expected, SIGMAS * standard_error):
        raise AssertionError(f"{what}: {value} +- {standard_error}, expected {expected} "
                             f"({100 * (value / expected - 1):+.3f} %)")
