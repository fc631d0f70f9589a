import pytest

from onika.wire import live, request
from onika.words.reason import Reason


def test_a_rate_is_changed_while_the_task_runs(sit):  # R-A04
    sitting = sit()
    sitting.does("spawn puma", "on puma", "rate puma 250")
    assert sitting.session.tasks()["puma"].frequency == 250.0
    assert sitting.states() == {"puma": "ON"}
    assert sitting.fails("rate puma often").reason == Reason.of("console.rate", word="often")


def test_a_task_is_initialised_anew_with_another_local_line(sit):  # R-A13
    sitting = sit()
    sitting.does("spawn jtraj", "reinit jtraj", "reinit jtraj SPEED 0.25", "reinit jtraj LABEL two words")
    plain, speed, label = sitting.requests_of(live.Reinit)
    assert plain.local is None
    assert speed.local == (("SPEED", ("0.25",)), ("SETTLE", ("0.5",)))
    assert dict(label.local)["LABEL"] == ("two", "words")
    assert sitting.fails("reinit jtraj SPEED").reason == Reason.of("console.local_words", key="SPEED")


def test_code_is_exchanged_for_that_of_its_file_or_of_another(sit, tmp_path):  # R-A14
    sitting = sit()
    sitting.does("spawn diff", "swap diff")
    other = tmp_path / "other.py"
    other.write_text("# other\n")
    sitting.does(f"swap diff {other}")
    shipped, given = sitting.requests_of(live.Swap)
    assert shipped.code.path.endswith("generic/module/diff.py")
    assert (given.code.source, given.code.module) == ("# other\n", "diff")
    assert shipped.code.digest != given.code.digest


def test_code_that_cannot_be_read_or_that_the_runtime_finds_faults_in_is_not_exchanged(sit, tmp_path):  # R-A14
    sitting = sit()
    sitting.does("spawn diff")
    assert sitting.fails(f"swap diff {tmp_path}/none.py").place.file == f"{tmp_path}/none.py"
    assert sitting.requests_of(live.Swap) == []
    sitting.runtime.faults = (
        request.FaultText(
            "diff.py", 3, Reason.plain("expected a class, found none"), Reason.plain("it is not exchanged")
        ),
    )
    fault = sitting.fails("swap diff")
    assert (fault.place.file, fault.place.line, str(fault.reason)) == ("diff.py", 3, "expected a class, found none")


def test_the_code_of_a_task_under_another_name_is_found_by_its_module(sit):
    sitting = sit()
    sitting.does("spawn jtraj as path", "swap path")
    assert sitting.requests_of(live.Swap)[0].code.path.endswith("jtraj.py")


def test_a_module_is_asked_and_told_by_name(sit):  # R-A01, R-A05
    sitting = sit()
    sitting.does("spawn jtraj", "set jtraj label two words")
    assert sitting.does("get jtraj label") == ["label = two words"]
    assert sitting.requests_of(live.Set) == [live.Set("main", "jtraj", "label", "two words")]
    assert (
        str(sitting.fails("get jtraj gain").reason)
        == "expected the module to do it, found there is nothing called 'gain' to get"
    )


def test_a_question_is_answered_with_words_or_with_a_target(asking):  # R-A10
    asking.does("spawn jtraj")
    output = asking.does("on jtraj")
    assert any("asks for endpoint double[2] in rad, where to go, from -1 -1 to 1 1" in line for line in output)
    assert asking.states() == {"jtraj": "ASKING"}
    asking.does("answer jtraj 0.5 0.5 2")
    assert asking.states() == {"jtraj": "ON"}
    asking.does("off jtraj", "on jtraj", "answer jtraj @home")
    assert [reply.line for reply in asking.requests_of(request.Reply)] == [
        "0.5 0.5 2",
        "0.0 -1.570796 1.570796 0.0 0.0 0.0 3.0",
    ]


def test_an_answer_that_will_not_do_is_asked_for_again(asking):  # R-A10
    asking.does("spawn jtraj", "on jtraj", "answer jtraj")
    assert asking.states() == {"jtraj": "ASKING"}
    assert ("main", "jtraj") in asking.session.questions


def test_an_answer_that_is_refused_leaves_the_question_open(asking):
    asking.does("spawn jtraj", "on jtraj")
    asking.runtime.refusals["Reply"] = "not yours"
    assert str(asking.fails("answer jtraj 1 1 1").reason) == "expected the runtime to do it, found not yours"
    assert ("main", "jtraj") in asking.session.questions


def test_only_a_task_that_asks_is_answered(asking):
    asking.does("spawn jtraj diff", "on jtraj")
    fault = asking.fails("answer diff 1")
    assert fault.reason == Reason.of("console.other_tasks_ask", asking=("main/jtraj",), word="diff")


def test_defaults_are_the_answer_where_every_input_has_one(sit):
    from onika.wire import event

    item = event.Item("label", "string", 1, "-", "its name", ("two words",), None, None)
    sitting = sit(asks={"diff": (item,)})
    sitting.does("spawn diff", "on diff", "answer diff")
    assert sitting.requests_of(request.Reply)[0].line == '"two words"'


@pytest.mark.parametrize("line", ["rate diff 5", "reinit diff", "swap diff", "get diff x", "set diff x 1"])
def test_what_does_not_live_cannot_be_altered(sit, line):
    assert sit().fails(line).reason == Reason.of("console.none_living", subsystem="main", name="diff")


def test_a_variable_that_nobody_writes_is_written_element_by_element(sit):  # R-C27
    sitting = sit()
    sitting.does("spawn jtraj", "write Q_MEZ 0 0.5 -1e-3")
    assert sitting.requests_of(live.Write) == [live.Write("main", "Q_MEZ", (0.0, 0.5, -0.001))]
    assert sitting.fails("write Q_MEZ 0 half").reason == Reason.of("console.numbers", words="0 half")
