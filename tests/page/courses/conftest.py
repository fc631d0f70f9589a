import re

import pytest

from .learner import Learner


@pytest.fixture
def learner(begin, page):
    """Somebody before whom nothing was done: opens the courses, in a language."""
    programs = []

    def opened(language="en"):
        page.add_init_script(f"localStorage.setItem('onika.language', '\"{language}\"')")
        programs.append(begin("--upper"))
        page.goto(programs[-1].address())
        me = Learner(page, language)
        page.get_by_role("button", name=re.compile(me.t("upper.first.tutorial"))).first.click()
        return me

    yield opened
    page.close()  # it must not miss its environment
    for program in programs:  # its workcell would take time from those that come
        program.end()
