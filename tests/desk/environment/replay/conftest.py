"""A session of a user, with its diary, and its replay on a copy of what there was at its beginning."""

import shutil
from pathlib import Path

import pytest

from kit.desk.app_fixture import ONIKONS, AppFixture
from onika.desk.environment import initial_model
from onika.desk.environment.diary import Diary
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.replay import replay_place
from onika.desk.environment.replay.session_player import SessionPlayer
from onika.desk.environment.session_start import SessionStart
from onika.files.rmod import RmodText
from onika.files.state import session_log
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.site import open_site

TASKS = (
    Task("sine", "sine", outvar=("Q_REF",), frequency=50.0),
    Task("servo", "servo", invar=("Q_REF", "Q_MEZ"), outvar=("T",), frequency=200.0),
    Task("arm", "arm", invar=("T",), outvar=("Q_MEZ",), frequency=400.0),
    Task("probe", "probe", invar=("Q_MEZ",), outvar=("X",), frequency=10.0),
)


class KeptSession(AppFixture):
    """A session at a base directory and a home of its own; `log` is what its diary says, when it has ended."""

    def __init__(self, folder: Path) -> None:
        self.lab, self.before = folder / "lab", folder / "before"
        base = BaseDirectory(self.lab)
        for onikon in ONIKONS:
            base.save_onikon(onikon)
        for task in TASKS:
            base.save_task(RmodText(task))
        shutil.copytree(self.lab, self.before)
        (folder / "home").mkdir()
        site = open_site([self.lab], {}, folder / "home")
        model, _ = initial_model.opened(site, None, {})
        super(AppFixture, self).__init__(folder, (), model, site)
        self.folder, self.at_s = folder, 770908202.0
        self.diary = Diary(folder / "diary", lambda: self.environment.model, self.say, self._now, SessionStart(site))
        self.environment.observers.append(self.diary.observe)
        self.environment.listening.append(self.diary.hear)
        self.environment.followers.append(self.diary.follow)

    def _now(self) -> float:
        self.at_s += 0.5
        return self.at_s

    @property
    def log(self) -> str:
        """The text of the diary; the session is over."""
        self.diary.close(30)
        return self.diary.path.read_text()

    def replay(self, log: str) -> SessionPlayer:
        """The session carried out once more, up to its end."""
        lines, faults = session_log.read(log, "s.log")
        place = replay_place.made(lines, [self.before], self.folder / "replay", "s.log")
        player = SessionPlayer(lines, place, HANDLERS, "s.log")
        player.faults[:0] = faults
        while player.step():
            pass
        return player

    def files(self) -> dict[str, bytes]:
        """What the user's files hold."""
        return {**written(self.lab), **written(self.home / "onika")}


def written(folder: Path) -> dict[str, bytes]:
    """The files below a folder, by their paths."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.fixture
def session(tmp_path: Path) -> KeptSession:
    """A session that is logged."""
    return KeptSession(tmp_path)
