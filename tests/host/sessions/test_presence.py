from onika.host.sessions.presence import Presence
from onika.wire import event, holding


class Doorway:
    def __init__(self, *names):
        self.names = list(names)
        self.told = []

    def sessions(self):
        return tuple(holding.SessionStanding(name, "operator") for name in self.names)

    def tell(self, message, subsystem="", session=""):
        self.told.append((message, subsystem, session))


def test_who_is_there_is_told_when_it_changes_to_those_who_want_to_know():  # R-X12
    session_source, watching = Doorway("one"), set()
    company = Presence(session_source, lambda: watching)
    company.look()
    company.look()
    session_source.names.append("two")
    company.look()
    watching.add("two")
    company.look()
    sessions = [
        [(session.name, session.only_watches) for session in message.sessions] for message, _, _ in session_source.told
    ]
    assert sessions == [[("one", False)], [("one", False), ("two", False)], [("one", False), ("two", True)]]
    assert {(type(message), where, who) for message, where, who in session_source.told} == {
        (event.Company, holding.COMPANY, "")
    }


def test_who_asks_learns_its_own_name():  # R-X12
    answer = Presence(Doorway("one", "two"), set).answer("two")
    assert (answer.you, [session.name for session in answer.sessions]) == ("two", ["one", "two"])


def test_where_nobody_is_nothing_is_told_and_who_has_no_lease_may_be_silent_for_ever():  # R-X12
    session_source = Doorway()
    company = Presence(session_source, set)
    company.look()
    assert session_source.told == []
    session_source.names.append("one")
    assert [session.lease_s for session in company.sessions()] == [0.0]


def test_how_long_each_may_be_silent_is_told_too():  # R-X12, network.md D4
    leases = {"one": 250_000_000, "two": 0}
    assert [session.lease_s for session in Presence(Doorway("one", "two"), set, leases.get).sessions()] == [0.25, 0.0]
