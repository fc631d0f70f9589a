"""Jobs whose return value chooses: what is in the hand, how wide it is open, whether the lamp is lit."""

import pytest

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench


def bench_of(lab, module, arguments=""):
    return Bench(shipped() / lab / "module" / f"{module}.py", frequency=50).init().on(arguments)


def end_of(bench, most=50):
    """Its return value: flow, loop; and after how many cycles."""
    while bench.state is State.ON and bench.cycles < most:
        bench.cycle()
    return (bench.finished.flow, bench.finished.loop), bench.cycles


@pytest.mark.parametrize(
    ("opening", "force", "returned"),
    [(0.076, 60.0, (1, True)), (0.0, 60.0, (0, False)), (0.112, 0.0, (0, False)), (0.076, 1.0, (0, False))],
)
def test_the_hand_holds_what_presses_on_fingers_that_are_apart(opening, force, returned):  # R-D10, R-E05
    bench = bench_of("puma", "holds")
    bench["GRIP_MEZ"] = [opening, 0.0, force]
    assert end_of(bench) == (returned, 5)


@pytest.mark.parametrize(("opening", "returned"), [(0.076, (1, True)), (0.045, (0, False)), (0.01, (0, False))])
def test_the_hand_is_open_wider_than_the_level_or_not(opening, returned):  # R-D10, R-E05
    bench = bench_of("puma", "wider", "0.045")
    bench["GRIP_MEZ"] = [opening, 0.0, 0.0]
    assert end_of(bench) == (returned, 5)


@pytest.mark.parametrize(("module", "arguments"), [("holds", ""), ("wider", "0.045")])
def test_whoever_looks_leaves_the_hand_as_it_is(module, arguments):  # law 3
    bench = Bench(shipped() / "puma" / "module" / f"{module}.py", frequency=50).init()
    bench["GRIP"] = -1.0
    bench.on(arguments).cycle(3)
    assert bench["GRIP"] == -1.0


def test_a_lamp_that_is_lit_is_seen_at_once_and_one_that_stays_dark_after_a_while():  # R-D10, R-E05
    lit, dark, late = (bench_of("boxes", "lamp_lit") for _ in range(3))
    lit["LAMP"] = 1
    assert end_of(lit) == ((1, False), 1)
    assert end_of(dark) == ((0, True), 20)
    late.cycle(10)
    late["LAMP"] = 1
    assert end_of(late) == ((1, False), 11)
