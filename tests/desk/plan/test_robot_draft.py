import sys

from kit.worlds.file_cells import ARM
from onika.desk.plan import robot_draft
from onika.desk.plan.robot_draft import drafted
from onika.wire.world_source import WorldFile, WorldSource

SOURCE = WorldSource("new", "", (WorldFile("robot/new.xml", "/lab/new.xml", ARM.encode()),))


def test_the_draft_comes_from_a_program_of_its_own():  # R-X19
    assert drafted(SOURCE, "new", "new.xml").home == (0.0, 0.0, 0.0)


def test_a_program_that_fails_is_told_with_its_last_words(monkeypatch):  # R-X19
    failing = (sys.executable, "-c", "raise SystemExit('no physics here')")
    monkeypatch.setattr(robot_draft, "DRAFTER", failing)
    refusal = drafted(SOURCE, "new", "new.xml").refusal
    assert refusal.key == "desk.robot_program" and "no physics here" in refusal.text
