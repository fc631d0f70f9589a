"""A world as somebody else's package installs it, in a folder that is put on PYTHONPATH."""

from pathlib import Path

CELL = """from onika.store.site import open_site
from onika.store.world_source import gather_world
from onika.workcell.filmed.filmed_world import FilmedWorld


class Cell(FilmedWorld):
    is_simulated = False

    def __init__(self):
        super().__init__(gather_world("boxes", open_site((), {}, None))[0])
"""
"""The same devices as `boxes`; nothing tells whoever asks that no machine moves."""


def install_world(folder: Path, name: str, source: str = CELL, kind: str = "Cell") -> Path:
    """Offer a world under the entry point `onika.worlds`; the folder."""
    package = f"{name}_of_test"
    (folder / f"{package}.py").write_text(source, encoding="utf-8")
    about = folder / f"{package}-1.0.dist-info"
    about.mkdir(parents=True)
    (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {package}\nVersion: 1.0\n", encoding="utf-8")
    (about / "entry_points.txt").write_text(f"[onika.worlds]\n{name} = {package}:{kind}\n", encoding="utf-8")
    return folder
