import pytest

from onika.engine import news as engine_news
from onika.host.run.engine_news import of_task
from onika.model.lifecycle import State
from onika.runtime import news
from onika.words.reason import NOTHING, Reason

GATE = Reason.of("host.signal_said", signal="ILLEGAL", text=Reason.plain("gate"))
NOT_ON = Reason.of("host.entry_failed", entry="on", why=Reason.plain("no"))
MEANINGS = [
    (news.Initialised("f", "arm"), State.WAITING, engine_news.Spawned(1, "arm")),
    (news.Initialised("f", "arm"), State.ERROR, engine_news.Cleared(1, "arm")),
    (news.Initialised("f", "arm"), State.OFF, None),
    (news.Changed("f", "arm", "ON", 1), State.OFF, engine_news.TurnedOn(1, "arm")),
    (news.Changed("f", "arm", "KILLED", 1), State.ON, engine_news.Killed(1, "arm")),
    (news.Changed("f", "arm", "OFF", 1), State.ERROR, engine_news.Cleared(1, "arm")),
    (news.Changed("f", "arm", "OFF", 1), State.ON, None),
    (news.Changed("f", "arm", "OFF", 1, "OFF"), State.ON, engine_news.SwitchedOff(1, "arm")),
    (news.Finished("f", "arm", 2, True, 1, switched=3), State.ON, engine_news.Finished(1, "arm", 2, True, 3)),
    (news.Asked("f", "arm", Reason.plain("why"), (), 1), State.ON, engine_news.Asked(1, "arm", Reason.plain("why"))),
    (news.Signalled("f", "arm", "ILLEGAL", 0, Reason.plain("gate"), 1), State.ON, engine_news.Illegal(1, "arm", GATE)),
    (news.Signalled("f", "arm", "LEGAL", 0, NOTHING, 1), State.ON, None),
    (news.Refused("f", "arm", "on", Reason.plain("no")), State.OFF, engine_news.Refused(1, "arm", NOT_ON)),
    (news.Refused("f", "arm", "rank", Reason.plain("no")), State.OFF, None),
    (news.Warned("f", "arm", Reason.plain("hot"), 1), State.ON, None),
]


@pytest.mark.parametrize(("message", "before", "meaning"), MEANINGS)
def test_the_engine_hears_what_matters_to_it(message, before, meaning):  # law 28
    assert of_task(1, message, before) == meaning


@pytest.mark.parametrize(("line", "text"), [(7, "cycle: no (arm.py:7)"), (0, "cycle: no")])
def test_a_failure_names_the_line_where_there_is_one(line, text):  # R-A18
    failed = news.Failed("f", "arm", "cycle", Reason.plain("no"), "arm.py", line, "", 1)
    meaning = of_task(1, failed, State.ON)
    assert (meaning.task, str(meaning.text)) == ("arm", text)
