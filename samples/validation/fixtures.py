"""The cases beyond CIE 171: simple sources, spheres, furnaces, reflectors, lenses, plates. Called by validate.py."""
import lenses
import reflectors
import sources_and_furnaces


def cases():
    return [*sources_and_furnaces.cases(), *reflectors.cases(), *lenses.cases()]
