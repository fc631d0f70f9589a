"""Class names that occur in several packages of src/onika, and whether that is right.

One word is for one thing. Two packages may have a class of one name only where it is the same idea on two sides of a
wall: a command as the page sends it and as a task gets it. Such names stand in pyproject.toml under
[tool.onika.shared-names], each behind the reason why it is shared.
"""

import ast
import tomllib
from pathlib import Path


def unexplained(root: Path) -> list[str]:
    """The shared names without a reason, with their packages; and the names with a reason that nobody shares."""
    packages = _packages_by_name(root / "src" / "onika")
    shared = {name: used for name, used in packages.items() if len(used) > 1}
    explained = _explained(root)
    without_reason = [f"{name} in {', '.join(sorted(shared[name]))}" for name in sorted(shared.keys() - explained)]
    needless = [f"{name} has a reason and is not shared" for name in sorted(explained - shared.keys())]
    return without_reason + needless


def _packages_by_name(house: Path) -> dict[str, set[str]]:
    packages: dict[str, set[str]] = {}
    for path in house.rglob("*.py"):
        package = path.relative_to(house).parts[0].removesuffix(".py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                packages.setdefault(node.name, set()).add(package)
    return packages


def _explained(root: Path) -> set[str]:
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))
    reasons: dict[str, list[str]] = project["tool"]["onika"].get("shared-names", {})
    return {name for names in reasons.values() for name in names}
