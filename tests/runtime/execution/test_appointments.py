import pytest

from onika.engine.rendezvous_terms import LATE_NS as AGREED_LATE_NS
from onika.ring.begin_words import BeginWords
from onika.runtime.command import Appointment
from onika.runtime.execution.appointments import LATE_NS, NEVER, SHARED_LATE_NS, Appointments, AppointmentStep

MS = 1_000_000
ORDER = Appointment(3, 100 * MS, 80 * MS, ("flow0",))


@pytest.fixture
def words():
    return BeginWords()


@pytest.fixture
def appointments(words):
    made = Appointments(words)
    made.keep(ORDER)
    return made


def steps(appointments, now):
    return [step for step, _ in appointments.due(now)]


def test_what_is_permitted_begins_at_its_time_and_not_before(words, appointments):  # law 34
    words.permit(3)
    assert (appointments.next_ns, steps(appointments, 100 * MS - 1)) == (100 * MS, [])
    assert appointments.due(100 * MS) == [(AppointmentStep.BEGIN, ORDER)]
    assert appointments.next_ns == 180 * MS


def test_what_is_not_permitted_or_late_does_not_begin(words, appointments):  # law 34
    assert steps(appointments, 100 * MS) == [AppointmentStep.MISS]
    assert appointments.next_ns == NEVER
    words.permit(3)
    for late_ns, step in ((LATE_NS, AppointmentStep.BEGIN), (LATE_NS + 1, AppointmentStep.MISS)):
        appointments.keep(ORDER)
        assert steps(appointments, 100 * MS + late_ns) == [step]
    assert LATE_NS == AGREED_LATE_NS


def test_without_real_time_it_may_begin_as_late_as_a_unit_gets_its_turn_there(words, appointments):  # law 34
    words.permit(3)
    appointments.late_ns = SHARED_LATE_NS
    assert steps(appointments, 100 * MS + SHARED_LATE_NS) == [AppointmentStep.BEGIN]
    appointments.keep(ORDER)
    assert steps(appointments, 100 * MS + SHARED_LATE_NS + 1) == [AppointmentStep.MISS]
    assert (LATE_NS, SHARED_LATE_NS) == (5 * MS, 20 * MS)  # as law 34 says


def test_what_nobody_confirms_is_held_so_long_after_its_time_however_late_it_began(words, appointments):  # law 34
    words.permit(3)
    appointments.due(104 * MS)
    assert steps(appointments, 180 * MS - 1) == []
    assert steps(appointments, 180 * MS) == [AppointmentStep.HOLD]
    assert steps(appointments, 300 * MS) == []


def test_what_is_confirmed_is_through(words, appointments):
    words.permit(3)
    appointments.due(100 * MS)
    words.confirm(3)
    assert (steps(appointments, 180 * MS), appointments.next_ns) == ([], NEVER)


def test_what_is_dropped_neither_begins_nor_is_held(words, appointments):
    words.permit(3)
    assert appointments.drop(3) == ORDER
    assert (appointments.drop(3), appointments.next_ns) == (None, NEVER)
    assert steps(appointments, 100 * MS) == []


def test_after_a_stop_those_that_have_not_begun_are_named(words, appointments):
    words.permit(3)
    appointments.due(100 * MS)
    later = Appointment(4, 500 * MS, 80 * MS, ("flow1",))
    appointments.keep(later)
    assert appointments.next_ns == 180 * MS
    assert (appointments.drop_all(), appointments.next_ns) == ([later], NEVER)


def test_without_appointments_nothing_is_ever_due(words):
    assert (Appointments(words).next_ns, NEVER) == (NEVER, 2**63)
    assert [step.value for step in AppointmentStep] == ["begin", "miss", "hold"]
