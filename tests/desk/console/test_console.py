from random import Random

import pytest

from kit.wire.message_fuzz import TEXTS
from onika.desk.console.display import Tone
from onika.wire import live, request
from onika.words.fault import Place
from onika.words.reason import Reason


def test_a_command_may_be_cut_to_what_tells_it_from_the_others(sit):  # R-A16
    sitting = sit()
    sitting.does("sp puma", "on puma")
    assert sitting.states() == {"puma": "ON"}
    fault = sitting.fails("s puma")
    assert fault.reason.key == "console.several_commands"
    assert sitting.fails("dance").reason == Reason.of("console.not_one_command", name="dance")


@pytest.mark.parametrize("line", ["", "   ", "# nothing"])
def test_an_empty_line_is_nothing(sit, line):
    sitting = sit()
    count = len(sitting.runtime.asked)
    assert sitting.console.carry_out(line) == ()
    assert len(sitting.runtime.asked) == count


def test_a_line_that_is_not_as_it_should_be_is_answered_with_how(sit):
    fault = sit().fails("rate puma")
    assert str(fault.reason) == "expected `rate TASK HZ`, found `rate puma`"
    assert str(sit().fails('spawn "puma').reason) == (
        "expected `spawn TASK… [on RTPU] [as NAME] [at HZ]  |  spawn all of CONFIGURATION`"
        ", found expected words, those with blanks in double quotes, found '\"puma'"
    )


@pytest.mark.parametrize("line", ["import os", "!ls", "$(touch x)", "; touch x", "echo `touch x`; touch x"])
def test_nothing_is_ever_carried_out_as_code_or_by_a_shell(sit, tmp_path, monkeypatch, line):
    monkeypatch.chdir(tmp_path)
    sitting = sit()
    sitting.console.carry_out(line)
    assert list(tmp_path.iterdir()) == []


def test_help_names_every_command_and_says_how_each_is_written(sit):  # R-A16
    sitting = sit()
    listed = sitting.does("help")
    for command in sitting.console._commands:
        assert any(line.split()[:1] == [command.name] for line in listed)
        assert sitting.does(f"help {command.name}")[0] == command.usage
    assert sitting.fails("help dance").reason == Reason.of("console.command_unknown", word="dance")


def test_the_required_commands_are_there(sit):  # R-A16
    names = {command.name for command in sit().console._commands}
    wanted = """
        spawn on off kill clear config answer rate get set reinit swap follow status tasks rtpus subsystem subsystems
        vars read watch log check run abort calibrate home stop reset take release open listen advance wait echo
        source help quit
    """
    assert names >= set(wanted.split())


def test_quit_ends_the_console_and_the_runtime_only_where_that_is_said(sit):
    sitting = sit()
    sitting.does("quit")
    assert (sitting.console.is_over, sitting.runtime.is_over) == (True, False)
    other = sit()
    other.does("quit runtime")
    assert (other.console.is_over, other.runtime.is_over) == (True, True)
    third = sit()
    assert third.fails("quit now").reason == Reason.of("console.quit_usage", word="now")
    third.runtime.refusals["Quit"] = "only its owner may"
    assert str(third.fails("quit runtime").reason) == "expected the runtime to do it, found only its owner may"
    assert not third.console.is_over


def test_a_question_is_answered_at_the_prompt_unless_the_line_is_a_command(asking):  # R-A10
    asking.does("spawn jtraj", "on jtraj")
    assert asking.console.answer("status") == ()
    assert asking.states() == {"jtraj": "ASKING"}
    assert asking.console.answer("0.5 0.5 2") == ()
    asking.session.hear()
    assert asking.states() == {"jtraj": "ON"}
    assert asking.console.answer("off jtraj") == ()
    assert [reply.line for reply in asking.requests_of(request.Reply)] == ["0.5 0.5 2"]


def test_stop_typed_at_a_question_stops(asking):  # law 27
    asking.does("spawn jtraj", "on jtraj")
    asking.console.answer("stop")
    assert asking.runtime.is_stopped


def test_a_late_answer_of_the_runtime_is_told_and_the_console_goes_on(sit):
    sitting = sit()

    def late(message):
        raise TimeoutError("no answer within 60 s")

    sitting.runtime.ask = late
    fault = sitting.fails("status")
    assert str(fault.reason) == "expected an answer of the runtime, found no answer within 60 s"


def test_a_script_is_carried_out_to_its_end(sit, tmp_path):  # R-A16
    path = tmp_path / "start"
    path.write_text("# the arm\nspawn puma diff\non puma\nrun go_home\necho there\n")
    sitting = sit()
    output = sitting.does(f"<{path}")
    assert output.index("there") > next(place for place, line in enumerate(output) if "run completed" in line)
    assert sitting.states() == {"puma": "ON", "diff": "OFF"}
    assert not sitting.session.in_script


def test_the_first_line_that_fails_ends_a_script_at_its_place(sit, tmp_path):  # R-A16
    path = tmp_path / "start"
    path.write_text("spawn puma\nspawn pumma\non puma\n")
    sitting = sit()
    (fault,) = sitting.console.run_script(path)
    assert str(fault).startswith(f"{path}:2: expected a task on the search path")
    assert sitting.states() == {"puma": "OFF"}


def test_faults_of_files_are_followed_by_the_line_that_met_them(sit, tmp_path):
    path = tmp_path / "start"
    path.write_text("spawn diff\nswap diff\n")
    sitting = sit()
    sitting.runtime.faults = (
        request.FaultText(
            "diff.py", 3, Reason.plain("expected a class, found none"), Reason.plain("it is not exchanged")
        ),
    )
    faults = sitting.console.run_script(path)
    assert [fault.place for fault in faults] == [Place("diff.py", 3), Place(str(path), 2)]


def test_scripts_within_scripts_come_to_an_end(sit, tmp_path):
    path = tmp_path / "loop"
    path.write_text(f"source {path}\n")
    sitting = sit()
    faults = sitting.console.run_script(path)
    assert any(fault.reason == Reason.of("console.scripts_too_deep", deepest=16, path=str(path)) for fault in faults)
    assert sitting.console.run_script(tmp_path / "none")[0].place.file == str(tmp_path / "none")


def test_a_script_ends_where_it_says_quit(sit, tmp_path):
    path = tmp_path / "start"
    path.write_text("quit\nspawn puma\n")
    sitting = sit()
    assert sitting.console.run_script(path) == ()
    assert sitting.console.is_over
    assert sitting.requests_of(live.Change) == []


def test_a_script_shows_its_lines(sit, tmp_path):
    path = tmp_path / "start"
    path.write_text("echo here\n")
    sitting = sit()
    sitting.does(f"source {path}")
    assert sitting.lines[-2:] == ["> echo here", "here"]
    assert sitting.tones[-2:] == [Tone.DIM, Tone.PLAIN]


def _anything(sitting, seed, count):
    """So many lines of known words and of others, each carried out or refused with its reason."""
    random = Random(seed)
    names = [command.name for command in sitting.console._commands if command.name not in ("source", "open", "listen")]
    words = [
        *names,
        "puma",
        "jtraj",
        "main",
        "all",
        "of",
        "on",
        "as",
        "at",
        "rt0",
        "50",
        "-1",
        "X",
        "X[0]",
        "==",
        *TEXTS,
    ]
    for _ in range(count):
        first = random.choice(names) if random.random() < 0.8 else random.choice(words)
        line = " ".join([first, *random.choices(words, k=random.randrange(5))])
        line = line[: random.randrange(len(line) + 1)] if random.random() < 0.1 else line
        for fault in sitting.console.carry_out(line):
            assert str(fault.reason)
        sitting.console.completion.candidates(line[:200])
        sitting.session.hear()
        sitting.console.is_over = False


@pytest.mark.parametrize("seed", [1, 2])
def test_no_line_ends_a_console(sit, tmp_path, monkeypatch, seed):  # R-A16, R-F01
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    monkeypatch.chdir(folder)
    _anything(sit(), seed, 300)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3, 9))
def test_no_line_ends_a_console_in_a_long_time(sit, tmp_path, monkeypatch, seed):  # R-A16, R-F01
    monkeypatch.chdir(tmp_path)
    _anything(sit(), seed, 10_000)
