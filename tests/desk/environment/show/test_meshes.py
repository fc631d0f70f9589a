import subprocess

import pytest
from msgspec import msgpack

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.worlds.file_cells import CELL
from onika.desk.environment.show import meshes
from onika.store.mesh_folder import MeshFolder
from onika.wire import act
from onika.wire.world_source import WorldSource

NAME, OTHER = "0" * 32, "1" * 32


@pytest.fixture
def env(tmp_path):
    env = FakeRuntimeEnv(tmp_path)
    for name, text in CELL.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    return env


class Maker:
    """Stands for the program that knows physics."""

    def __init__(self, answer):
        self.answer = answer
        self.asked = []

    def __call__(self, words, **how):
        files = msgpack.decode(how["input"], type=WorldSource)
        self.asked.append((files.world, words[len(meshes.MAKER) :]))
        if isinstance(self.answer, Exception):
            raise self.answer
        return subprocess.CompletedProcess(words, 0, self.answer, b"")


def ask(env, names, world="cell"):
    """The names that are there afterwards."""
    return env.later(act.Meshes(world, names)).value


def test_meshes_that_are_lacking_are_made_once(env, tmp_path, monkeypatch):  # R-X19
    maker = Maker(msgpack.encode({NAME: b"mesh"}))
    monkeypatch.setattr(subprocess, "run", maker)
    assert ask(env, (NAME, OTHER)) == [NAME]
    assert MeshFolder(tmp_path / "state").lacking([NAME]) == []
    assert ask(env, (NAME,)) == [NAME]
    assert maker.asked == [("cell", [NAME, OTHER])]


@pytest.mark.parametrize("wrong", [b"no msgpack", OSError("gone"), subprocess.TimeoutExpired("maker", 1)])
def test_a_program_that_fails_leaves_boxes_as_they_are(env, monkeypatch, wrong):  # R-X19
    monkeypatch.setattr(subprocess, "run", Maker(wrong))
    assert ask(env, (NAME,)) == []


def test_of_a_world_that_is_no_file_nothing_is_made(env, monkeypatch):  # R-X19
    maker = Maker(b"")
    monkeypatch.setattr(subprocess, "run", maker)
    assert ask(env, (NAME, "../token"), "boxes") == []
    assert maker.asked == []
