"""An environment to try acts on what is installed: a copy of two laboratories that tests may spoil, and a home.

desk = InstalledFixture(tmp_path, monkeypatch)
desk.write("pd", "code", "nonsense")
desk.installed_files() == desk.before
"""

import shutil
from pathlib import Path
from typing import Any, Literal

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.file.disk_watch import DiskWatch
from onika.desk.environment.initial_model import opened
from onika.desk.environment.refresh import refreshed
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.wire import act


class InstalledFixture(EnvironmentFixture):
    """The search path is the user's own `own`, which is not there yet, then `boxes` and `generic`."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        labs = folder / "installed"
        for name in ("boxes", "generic"):
            shutil.copytree(shipped() / name, labs / name, ignore=shutil.ignore_patterns("__pycache__"))
        self.generic = BaseDirectory(labs / "generic")
        self.before = _files(labs)
        monkeypatch.setattr("onika.store.shipped.shipped", lambda: labs)
        (folder / "home").mkdir()
        site = open_site([], {}, folder / "home")
        model, self.told = opened(site, None, {})
        super().__init__(folder, (), model, site)
        self.home = folder / "home"
        self.own = BaseDirectory(self.home / "onika")
        self.disk = DiskWatch(site)

    def installed_files(self) -> dict[str, bytes]:
        """Everything that is installed, by path."""
        return _files(self.generic.path.parent)

    def write(self, task: str, kind: Literal["rmod", "code"], text: str, **more: bool) -> Any:
        """Save a text as the source panel does; its view."""
        source = self.do(act.ReadText(task, kind))
        return self.do(act.WriteText(task, kind, text, source.stamp, **more))

    def look(self) -> None:
        """What the program does every second."""
        changed = self.disk.changed(self.environment.model)
        self.says.clear()
        self.environment.become(lambda model: refreshed(model, changed, self.site))

    def sentences(self) -> list[str]:
        """What was said since the last look."""
        return [str(line.text) for line in self.says]


def _files(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}
