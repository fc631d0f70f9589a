import pytest

from kit.desk.runtime_line import RuntimeLine
from onika.desk.run.runtime_conversation import NumberedResponse
from onika.link.lost import LinkLost, LossCause
from onika.wire import live, request
from onika.words.reason import Reason


def test_a_line_answers_but_what_it_is_to_pass_over_and_ends_as_it_is_told():
    with RuntimeLine() as line:
        line.silent = (live.Survey,)
        assert line.send(live.Survey()) == 1 and line.send(request.Stop(Reason.plain("stop"))) == 2
        answer, stopped = line.messages()
        assert answer == NumberedResponse(2, request.Done()) and stopped.is_stopped
        line.say(LinkLost(LossCause.CLOSED, Reason.plain("the cable")))
        with pytest.raises(LinkLost):
            list(line.messages())
    assert line.is_left
