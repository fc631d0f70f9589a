"""One class for all tests of a file that need a real one."""

import pytest

from kit.process.class_process import ClassProcess
from onika.process import confinement


@pytest.fixture(scope="module")
def school(tmp_path_factory):
    """A class of four seats; where the kernel has no Landlock it does without."""
    words = () if confinement.level() else ("--unconfined",)
    process = ClassProcess(
        tmp_path_factory.mktemp("school"), "--seats", "4", "--expect", "Q_MEZ[0] > -9", "go_home", *words
    )
    yield process
    assert process.end() in (0, 130)
