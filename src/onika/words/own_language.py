"""The language of whoever reads what this process prints: that of the variable ONIKA_LANG, else English.

The variable stands in the environment, so that a program launched from here speaks it too.
"""

import os

from onika.words.sentence import LANGUAGES

VARIABLE = "ONIKA_LANG"


def own_language() -> str:
    """The language of this process."""
    wanted = os.environ.get(VARIABLE, "")
    if wanted in LANGUAGES:
        return wanted
    return LANGUAGES[0]
