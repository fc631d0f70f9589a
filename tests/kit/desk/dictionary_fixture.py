"""An environment to try acts on dictionaries: a home, a base directory of a laboratory and one that is shipped.

env = DictionaryFixture(tmp_path)
env.do(act.MakeTarget("there", "Pause object", (("1",),), WHITE))
env.icon("there").values
"""

from pathlib import Path

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.file.disk_watch import DiskWatch
from onika.desk.environment.initial_model import opened
from onika.desk.environment.refresh import refreshed
from onika.files import syntax
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.wire.view import OnikonView

WHITE = "7" * 1024


def plain(name: str, kind: str = "Complete job", description: str = "", *values: tuple[float, ...]) -> Onikon:
    """An icon with an empty picture."""
    return Onikon(name, kind, description, values, blank())


class DictionaryFixture(EnvironmentFixture):
    """The search path is `base`, then the user's own `own`, which is not there yet, then what is shipped."""

    def __init__(self, folder: Path, *onikons: Onikon) -> None:
        base = BaseDirectory(folder / "lab")
        for onikon in onikons:
            base.save_onikon(onikon)
        base.path.mkdir(parents=True, exist_ok=True)
        (folder / "home").mkdir(exist_ok=True)
        site = open_site([base.path], {}, folder / "home")
        model, self.told = opened(site, None, {})
        super().__init__(folder, (), model, site)
        self.base = base
        self.own = BaseDirectory(folder / "home" / "onika")
        self.home = folder / "home"
        self.disk = DiskWatch(site)

    def look(self) -> int:
        """What the program does every second; the number of patches that came of it."""
        changed = self.disk.changed(self.environment.model)
        before = self.environment.revision
        self.says.clear()
        self.environment.become(lambda model: refreshed(model, changed, self.site))
        return self.environment.revision - before

    def define(self, *lines: str) -> Path:
        """Have the user's own syntax be the shipped one with lines before its edges; the file."""
        path = self.home / syntax.NAME
        text = (shipped() / "prefs" / syntax.NAME).read_text("utf-8")
        head, edges = text.split("EDGENUM", 1)
        path.write_text(head + "\n".join(lines) + "\n\nEDGENUM" + edges, encoding="utf-8")
        return path

    def icon(self, name: str) -> OnikonView:
        """How the page sees an icon; raises KeyError where no open dictionary has it."""
        return self.environment.tree.onikons[name]

    @property
    def names(self) -> list[str]:
        """The icons that are not shipped, as the page has them."""
        icons = self.environment.tree.onikons.items()
        return [name for name, view in icons if view.dictionary in (str(self.base.path), str(self.own.path))]
