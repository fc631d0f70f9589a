import pytest

from onika.cli import doctor as room, main
from onika.desk.run.machine import Feature
from onika.words.reason import Reason

GOOD = Feature(Reason.plain("python"), True, Reason.plain("3.11.7"), Reason.plain("Onika needs it"))
BAD = Feature(Reason.plain("graphics"), False, Reason.plain("none [bold]"), Reason.plain("no pictures"))


@pytest.mark.parametrize(("is_there", "code"), [([GOOD], 0), ([GOOD, BAD], 1)])
def test_what_is_there_and_what_lacking_it_costs_is_told(monkeypatch, capsys, is_there, code):  # law 31
    monkeypatch.setattr(room, "features", lambda: is_there)
    assert main(["doctor"]) == code
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].split() == ["ok", "python", "3.11.7"]
    if code:
        assert lines[1].split() == ["no", "graphics", "none", "[bold]"]
        assert lines[2].strip() == "cost: no pictures"
    assert len(lines) == (3 if code else 1)


def test_the_loop_of_a_job_is_printed_for_each_rate(capsys):
    assert main(["doctor", "--sweep", "jmoveC"]) == 0
    out = capsys.readouterr().out
    assert [line for line in out.splitlines() if line.startswith("# ")] == ["# 500 Hz", "# 250 Hz", "# 50 Hz"]
    assert "signal = jtraj.cycle()" in out


def test_a_sweep_of_no_job_is_refused_with_the_reason(capsys):
    assert main(["doctor", "--sweep", "nosuch"]) == 2
    said = capsys.readouterr()
    assert (said.out, said.err.startswith("nosuch: expected the name of a configuration")) == ("", True)
