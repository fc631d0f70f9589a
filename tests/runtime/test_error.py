import pytest

from onika.module import AskAgain, ModuleError
from onika.runtime.error import LawBroken


def test_a_broken_law_is_told_as_a_modules_error():  # law 5
    with pytest.raises(ModuleError, match="NaN"):
        raise LawBroken("NaN in TAU_REF")


def test_a_question_is_no_error():  # R-A10
    assert not issubclass(AskAgain, ModuleError)
