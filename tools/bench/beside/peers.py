"""The peers' packages: installed one by one on demand, so that one that cannot be installed harms no other.

`python -m beside.peers` installs them into the environment it runs in; what went wrong is kept there and told.
"""

import json
import subprocess
import sys
from pathlib import Path

PACKAGES = {
    "drake": ("drake",),
    "bdsim": ("bdsim",),
    "pathsim": ("pathsim",),
    "py_trees": ("py_trees",),
    "iceoryx2": ("iceoryx2",),
    "pyzmq": ("pyzmq",),
    "eclipse-zenoh": ("eclipse-zenoh",),
    "dora-rs": ("dora-rs", "dora-rs-cli"),
}
"""What each of them needs, by the name of its package."""

FAILURES = Path(sys.prefix) / "peers-that-failed.json"


def why_absent(package: str) -> str:
    """Why a package could not be installed; empty where it was, or where nobody has tried."""
    if not FAILURES.exists():
        return ""
    return str(json.loads(FAILURES.read_text()).get(package, ""))


def install() -> dict[str, str]:
    """Install all; those that failed, with the last thing that was said."""
    failed = {}
    for package, wanted in PACKAGES.items():
        words = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *wanted]
        ran = subprocess.run(words, capture_output=True, text=True, check=False)
        if ran.returncode:
            said = [one for one in ran.stderr.splitlines() if one.startswith("ERROR:")] or ["pip failed"]
            failed[package] = f"cannot be installed: {said[-1].removeprefix('ERROR:').strip()}"
            print(f"{package} {failed[package]}", file=sys.stderr)
    return failed


if __name__ == "__main__":
    FAILURES.write_text(json.dumps(install(), indent=1))
