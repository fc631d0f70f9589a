import os
from pathlib import Path

import pytest

from kit.process.process_tree import descendants
from onika.classroom.seat_program import NICE, readable
from onika.process import confinement
from onika.store.shipped import shipped


def test_a_seat_reads_the_system_onika_and_what_its_teacher_has_put_there(tmp_path):  # R-X25
    places = readable((tmp_path,))
    assert tmp_path in places
    assert any(shipped().is_relative_to(place) for place in places)
    for private in (Path("/"), Path("/home"), Path("/root"), Path("/tmp"), Path("/var"), Path("/run")):
        assert private not in places


@pytest.mark.site
def test_a_seat_stands_behind_its_class_in_a_session_and_a_folder_of_its_own(school):  # R-X25
    school.joined("Zoe")
    rows = school.teacher.until(lambda rows: rows["Zoe"]["processes"] >= 1)
    seats = []
    for pid in descendants(school.pid):
        words = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        if int(words[3]) == pid:
            seats.append((int(words[16]), "NoNewPrivs:\t1" in Path(f"/proc/{pid}/status").read_text()))
    behind = min(19, os.getpriority(os.PRIO_PROCESS, 0) + NICE)
    assert (behind, confinement.level() > 0) in seats
    folder = school.folder / "seats" / f"{rows['Zoe']['seat']:02}"
    assert {"home", "state", "cache", "tmp", "seat.log"} <= {path.name for path in folder.iterdir()}
    assert folder.stat().st_mode & 0o077 == 0
