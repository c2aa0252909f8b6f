"""All cases beyond CIE 171: reflectors, lenses and plates, simple sources, spheres and furnaces. Called by validate.py."""
import lenses
import reflectors
import sources_and_furnaces


def cases():
    return [*sources_and_furnaces.cases(), *reflectors.cases(), *lenses.cases()]
