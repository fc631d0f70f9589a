from onika.desk.environment.outcome.gathered_responses import GatheredResponses
from onika.desk.environment.outcome.outcome import AskAll, Order
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.wire import live, request
from onika.words.reason import Reason


def test_all_responses_come_together_in_the_order_of_the_questions():  # R-F02
    gathered = GatheredResponses()
    question = AskAll(Model(OpenLibraries(())), (("", live.Survey()), ("cmu", live.Survey())))
    here, there = gathered.begin(question)
    assert (here.station, there.station) == ("", "cmu")
    refused = request.Refused(Reason.plain("not now"))
    assert gathered.take(Order(live.Survey()), refused) is None
    assert gathered.take(there, refused) is None
    assert gathered.take(here, request.Done()) == (question, (request.Done(), refused))
    assert gathered.take(here, request.Done()) is None
