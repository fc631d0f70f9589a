"""Where parameter sets are kept: beside their configuration, of a shipped one in the user's own base directory."""

from pathlib import Path

from onika.files import parameter_sets
from onika.model.parameter_set import ParameterSet
from onika.store.opened_text import Faults, OpenedText, open_file, save
from onika.store.own_copy import saving_place
from onika.store.site import Site
from onika.words.fault import Refusal

Sets = tuple[ParameterSet, ...]


def place(base: Path, name: str, site: Site) -> Path | Refusal:
    """The file of the sets of the configuration `name` of a base directory; refused where none could be kept."""
    home = saving_place(base, site)
    if isinstance(home, Refusal):
        return home
    return home.configuration_file(name).with_suffix(parameter_sets.ENDING)


def opened(path: Path) -> tuple[OpenedText[Sets] | None, Faults]:
    """The sets that are kept there; none where there is no such file."""
    if not path.exists():
        return None, ()
    return open_file(path, path.stem, parameter_sets.read)


def kept(path: Path, sets: Sets, former: OpenedText[Sets] | None) -> OpenedText[Sets] | Refusal:
    """Write the sets where the file is still what it was read as."""
    return save(path, sets, parameter_sets.write, former, overwrites=False)
