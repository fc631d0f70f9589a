import pytest

from onika.cli import main
from onika.cli.study.command import VERBS


def test_every_verb_is_in_the_help_and_has_one(capsys):
    with pytest.raises(SystemExit):
        main(["study", "--help"])
    text = capsys.readouterr().out
    assert all(f"\n    {verb}" in text for verb in VERBS)
    with pytest.raises(SystemExit) as ended:
        main(["study"])
    assert ended.value.code == 2
