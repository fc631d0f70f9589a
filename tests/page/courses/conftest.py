import re

import pytest

from .learner import Learner


@pytest.fixture
def learner(begin, page):
    """Somebody before whom nothing was done: opens the courses, in a language."""

    def opened(language="en"):
        page.add_init_script(f"localStorage.setItem('onika.language', '\"{language}\"')")
        page.goto(begin("--upper").address())
        me = Learner(page, language)
        page.get_by_role("button", name=re.compile(me.t("upper.first.tutorial"))).first.click()
        return me

    return opened
