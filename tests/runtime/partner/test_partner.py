"""The partner of a task: answers, and all the ways in which there is none."""

import gc
import sys

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.runtime.error import ModuleError
from onika.runtime.partner.partner import Partner
from onika.runtime.partner.protocol import LONGEST
from onika.testing.fake_partner import FakePartner, wait

ECHO = "import json, sys\nfor line in sys.stdin:\n    m = json.loads(line)\n"
ECHO += "    print(json.dumps({'id': m['id'], 'x': m['x']}), flush=True)\n"


@pytest.fixture
def outsider(tmp_path):
    with FakePartner(tmp_path) as made:
        yield made


@pytest.fixture
def make():
    made = []

    def partner(*words, **given):
        made.append(Partner(*words, **given))
        return made[-1]

    yield partner
    for partner in made:
        partner.close()


@pytest.fixture
def partner(outsider, make):
    return make(outsider.address, patience_s=10.0)


def fault(partner):
    with pytest.raises(ModuleError) as caught:
        wait(partner)
    assert not partner.is_awaited
    return str(caught.value)


# Answers


def test_question_and_answer(partner, outsider):  # R-F04
    partner.task = "home/one"
    partner.ask("double", x=2)
    assert partner.is_awaited
    call = outsider.accept()
    question = call.read()
    assert (question["task"], question["ask"], question["x"]) == ("home/one", "double", 2)
    call.answer(question, y=4)
    assert wait(partner)
    assert partner.answer.number("y") == 4.0
    assert not partner.has_answered(), "an answer is told once"


def test_the_connection_is_used_again_and_its_descriptor_stays(partner, outsider):
    descriptor = partner.fileno()
    partner.ask("a")
    call = outsider.accept()
    call.answer(call.read())
    assert wait(partner)
    partner.ask("b")
    assert call.read()["ask"] == "b"
    assert partner.fileno() == descriptor


def test_a_second_question_before_the_answer_is_refused(partner):  # R-F04: no queue that lags behind
    partner.ask("a")
    with pytest.raises(ModuleError, match="one question at a time"):
        partner.ask("b")


def test_a_long_question_is_sent_in_parts(partner, outsider):
    partner.ask("a", x="y" * (LONGEST - 100))
    call = outsider.accept()
    call.answer(call.read())
    assert wait(partner)


def test_two_tasks_with_one_partner_have_a_connection_each(outsider, make):  # R-F04
    first, other = make(outsider.address, patience_s=10.0), make(outsider.address, patience_s=10.0)
    first.ask("mine", x=1)
    other.ask("mine", x=2)
    calls = [outsider.accept(), outsider.accept()]
    for call in reversed(calls):
        question = call.read()
        call.answer(question, x=question["x"])
    assert wait(first)
    assert wait(other)
    assert (first.answer.number("x"), other.answer.number("x")) == (1.0, 2.0)


# No answer


def test_a_partner_that_never_answers(outsider, make):  # R-F04
    partner = make(outsider.address, patience_s=0.05)
    partner.ask("a")
    assert fault(partner) == f"partner {outsider.address}: no answer within 0.05 s"


def test_a_partner_that_answers_late_is_passed_over_and_may_answer_the_next_question(outsider, make):  # R-F04
    partner = make(outsider.address, patience_s=0.05)
    partner.ask("a")
    call = outsider.accept()
    late = call.read()
    fault(partner)
    partner.patience_s = 10.0
    partner.ask("b")
    question = call.read()
    call.answer(late, x="late").answer(question, x="now")
    assert wait(partner)
    assert (partner.answer.fields["x"], partner.late) == ("now", 1)


def test_where_nobody_listens_it_is_tried_until_patience_ends(tmp_path, make):  # R-F04
    partner = make(FakePartner(tmp_path, listens=False).address, patience_s=0.12)
    partner.ask("a")
    assert fault(partner).endswith("nobody listens (No such file or directory)")


def test_a_partner_that_comes_up_while_it_is_asked_is_found(tmp_path, make):  # R-F04
    with FakePartner(tmp_path, listens=False) as outsider:
        partner = make(outsider.address, patience_s=10.0)
        partner.ask("a")
        partner.hear()
        outsider.open()
        assert not partner.has_answered()
        while not partner._stands:
            wait(partner, 0.06)
        call = outsider.accept()
        call.answer(call.read())
        assert wait(partner)


def test_a_refused_port_is_told_as_such(make):
    partner = make("tcp:127.0.0.1:9", patience_s=0.06)
    partner.ask("a")
    assert "nobody listens (Connection refused)" in fault(partner)


def test_a_partner_that_dies_in_the_middle(partner, outsider):  # R-F04
    partner.ask("a")
    call = outsider.accept()
    call.read()
    call.close()
    assert fault(partner).endswith("it ended the connection before it answered")


def test_a_partner_that_was_started_anew_between_two_questions_is_called_again(partner, outsider):  # R-F04
    partner.ask("a")
    call = outsider.accept()
    call.answer(call.read())
    assert wait(partner)
    call.close()
    partner.ask("b")
    call = outsider.accept()
    call.answer(call.read(), x=3)
    assert wait(partner)
    assert partner.answer.number("x") == 3.0


def test_a_partner_that_says_no(partner, outsider):
    partner.ask("a")
    call = outsider.accept()
    call.answer(call.read(), error="I would rather not")
    assert fault(partner).endswith("it says: I would rather not")
    with pytest.raises(ModuleError, match="expected an answer, found none"):
        _ = partner.answer


def test_what_a_partner_says_writes_no_lines_of_its_own(partner, outsider):  # R-F04
    partner.ask("a")
    call = outsider.accept()
    call.answer(call.read(), error="no\n     0.50 s  drive boxes:arm_left HELD\r\n")
    assert fault(partner).endswith("it says: no 0.50 s drive boxes:arm_left HELD")


# A partner that breaks the rules


@pytest.mark.parametrize("data", [b"what?\n", b'{"id": 99}\n', b'{"id": 1, "x": NaN}\n', b"x" * (LONGEST + 1)])
def test_a_partner_that_lies_is_hung_up_on(partner, outsider, data):  # R-F04
    partner.ask("a")
    call = outsider.accept()
    call.read()
    call.say(data)
    assert "expected" in fault(partner)
    assert call.has_ended()


def test_a_partner_that_floods_is_hung_up_on_even_when_nothing_is_asked(partner, outsider):  # R-F04
    partner.ask("a")
    call = outsider.accept()
    call.answer(call.read())
    assert wait(partner)
    call.say(b'{"id": 1}\n' * 200)
    assert "one answer to each question" in fault(partner)
    assert call.has_ended()


@settings(max_examples=examples(30), deadline=None)
@given(data=st.binary(min_size=1, max_size=100))
def test_any_bytes_are_an_answer_or_a_fault_and_never_anything_else(tmp_path_factory, data):  # R-F04
    with FakePartner(tmp_path_factory.mktemp("p")) as outsider:
        partner = Partner(outsider.address, patience_s=0.01)
        partner.ask("a")
        call = outsider.accept()
        call.read()
        call.say(data + b"\n")
        try:
            assert wait(partner)
            assert partner.answer.fields["id"] == 1
        except ModuleError:
            pass
        partner.close()


# A program that is started


def test_a_program_that_is_started_talks_over_its_own_input_and_output(make):  # R-F04
    partner = make(starts=f'{sys.executable} -c "{ECHO}"', patience_s=20.0)
    partner.ask("a", x=5)
    assert wait(partner, 20.0)
    assert partner.answer.number("x") == 5.0


def test_with_an_address_it_is_started_and_called_there(tmp_path, make):  # R-F04
    script = tmp_path / "server.py"
    script.write_text(
        "import json, os, socketserver\nclass H(socketserver.StreamRequestHandler):\n    def handle(self):\n"
        "        for line in self.rfile:\n"
        "            self.wfile.write(json.dumps({'id': json.loads(line)['id']}).encode() + b'\\n')\n"
        "socketserver.UnixStreamServer(os.environ['ONIKA_PARTNER'][5:], H).serve_forever()\n"
    )
    partner = make(f"unix:{tmp_path / 'door'}", f"{sys.executable} {script}", patience_s=20.0)
    partner.ask("a")
    assert wait(partner, 20.0)


@pytest.mark.parametrize("at", ["", "unix:/nowhere/at/all"])
@pytest.mark.parametrize(
    ("command", "how"), [("/no/such/program", "cannot be started: No such"), ("false", "ended with exit code 1")]
)
def test_a_program_that_ends_says_how(make, at, command, how):  # R-F04
    partner = make(at, command, patience_s=20.0)
    partner.ask("a")
    assert f"its program {how}" in fault(partner)


def test_a_program_that_has_ended_is_started_again_when_the_task_comes_on(make):  # R-F04
    once = ECHO + "    break\n"
    partner = make(starts=f'{sys.executable} -c "{once}"', patience_s=20.0)
    partner.ask("a", x=1)
    assert wait(partner, 20.0)
    while not (partner._started.how_ended or partner._line is None):
        wait(partner, 0.1)
    partner.begin()
    partner.ask("a", x=2)
    assert wait(partner, 20.0)
    assert partner.answer.number("x") == 2.0


# Its life


def test_off_gives_the_question_up_and_keeps_the_connection(partner, outsider):
    partner.ask("a")
    call = outsider.accept()
    old = call.read()
    partner.rest()
    assert not partner.is_awaited
    partner.begin()
    partner.ask("b")
    question = call.read()
    call.answer(old, x=1).answer(question, x=2)
    assert wait(partner)
    assert partner.answer.number("x") == 2.0


def test_what_came_of_a_question_before_off_is_forgotten_at_on(outsider, make):
    partner = make(outsider.address, patience_s=0.01)
    partner.ask("a")
    call = outsider.accept()
    call.say(b"nonsense\n")
    while not partner.is_settled:
        partner.hear()
    partner.begin()
    assert not partner.is_settled
    assert not partner.has_answered()


def test_a_partner_that_is_forgotten_hangs_up(outsider):
    partner = Partner(outsider.address)
    partner.ask("a")
    call = outsider.accept()
    call.read()
    del partner
    gc.collect()
    assert call.has_ended()


@pytest.mark.parametrize(
    ("given", "reason"),
    [
        ({}, "expected where a partner listens or what starts it, found neither"),
        ({"at": "http://x"}, "expected unix:PATH or tcp:HOST:PORT"),
        ({"starts": 'a "b'}, "No closing quotation"),
        ({"at": "unix:/x", "patience_s": 0.0}, "patience of 0.001 to 3600 s"),
        ({"at": "unix:/x", "patience_s": float("nan")}, "patience of 0.001 to 3600 s"),
    ],
)
def test_words_that_cannot_be_used_are_refused(given, reason):
    with pytest.raises(ModuleError, match=reason):
        Partner(**given)


def test_to_hang_up_gives_the_question_up_and_the_next_one_calls_again(partner, outsider):  # R-A20
    partner.ask("double", x=1)
    first = outsider.accept()
    first.read()
    partner.hang_up()
    assert first.has_ended()
    assert not partner.is_awaited
    partner.ask("double", x=2)
    call = outsider.accept()
    call.answer(call.read(), y=4)
    assert wait(partner)
