"""Asks the advisory databases about everything that Onika brings along and the page is built with.

Usage: python tools/audit.py [--venv FOLDER]. Python's packages are asked about by pip-audit, in a virtual environment
of its own; npm's by `npm audit`, from the lock file. Where no database can be reached that is said, and is no failure;
otherwise the tool ends with 1 where an advisory fits a package, and with the code of the audit where that failed.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
import venv
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT), str(Path(__file__).parent)]

import hatch_build  # noqa: E402  # it stands beside the project, not in it

import licences  # noqa: E402

_UNREACHED = re.compile(
    r"Could not connect|ConnectionError|NameResolutionError|Max retries exceeded|Timeout|HTTPError|SSLError"
    r"|audit endpoint returned an error|No matching distribution found|ENOTFOUND|ECONNREFUSED|ENETUNREACH"
)
_NOBODY = "no advisory database can be reached, no package was looked up"
_TIMEOUT_S = 300


@dataclass(frozen=True)
class Verdict:
    """What an audit says, line by line, and the code with which it ends the tool."""

    lines: tuple[str, ...]
    code: int = 0


@dataclass(frozen=True)
class Outcome:
    """How a program ended."""

    code: int
    output: str
    errors: str


def judge_pip_audit(outcome: Outcome) -> Verdict:
    """What pip-audit found out; a package that it skipped was not looked up, and is told."""
    dependencies = _json(outcome.output).get("dependencies")
    if not dependencies:
        return _not_audited("pip-audit", outcome)
    skipped = [each["name"] for each in dependencies if "skip_reason" in each]
    if len(skipped) == len(dependencies):
        return Verdict((f"pip-audit: {_NOBODY}",))
    advisories = tuple(_pip_advisories(dependencies))
    counted = f"pip-audit: {len(dependencies) - len(skipped)} packages looked up, {len(advisories)} advisories"
    missed = (f"pip-audit: not looked up: {', '.join(skipped)}",) if skipped else ()
    return Verdict((counted, *advisories, *missed), code=1 if advisories else 0)


def judge_npm_audit(outcome: Outcome) -> Verdict:
    """What npm found out."""
    report = _json(outcome.output)
    if "auditReportVersion" not in report:
        return _not_audited("npm audit", outcome)
    packages: Mapping[str, Any] = report.get("vulnerabilities", {})
    advisories = tuple(f"  {name}: {about.get('severity')}, {about.get('range')}" for name, about in packages.items())
    return Verdict((f"npm audit: {len(advisories)} packages with advisories", *advisories), outcome.code)


def main(words: list[str]) -> int:
    """Ask both, and say what they said."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--venv", type=Path, default=ROOT / ".venv-audit", help="where pip-audit is installed")
    given = parser.parse_args(words)
    verdicts = (_audit_python(given.venv), _audit_page())
    for verdict in verdicts:
        print("\n".join(verdict.lines))
    return max(verdict.code for verdict in verdicts)


def _audit_python(folder: Path) -> Verdict:
    program = folder / "bin" / "pip-audit"
    if not program.exists():
        venv.create(folder, with_pip=True, clear=True)
        fetched = _run([str(folder / "bin" / "pip"), "install", "--disable-pip-version-check", "pip-audit"])
        if fetched.code:
            return _not_audited("pip install pip-audit", fetched)
    with tempfile.TemporaryDirectory() as temporary:
        pinned = Path(temporary) / "requirements.txt"
        pinned.write_text("".join(_pinned()), encoding="utf-8")
        options = ("--disable-pip", "--no-deps", "--progress-spinner", "off", "--format", "json")
        return judge_pip_audit(_run([str(program), *options, "--requirement", str(pinned)]))


def _audit_page() -> Verdict:
    command = [*hatch_build.npm_command(), "audit", "--package-lock-only", "--json"]
    return judge_npm_audit(_run(command, ROOT / "browser"))


def _pinned() -> Iterator[str]:
    """What is installed of the packages that ship, with its versions."""
    for package in licences.python_packages(ROOT, {}):
        try:
            yield f"{package.name}=={metadata.version(package.name)}\n"
        except metadata.PackageNotFoundError:
            continue  # another version of Python needs it


def _run(command: Sequence[str], folder: Path = ROOT) -> Outcome:
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=_TIMEOUT_S, check=False)
    except subprocess.TimeoutExpired:
        return Outcome(1, "", f"Timeout after {_TIMEOUT_S} s")
    return Outcome(done.returncode, done.stdout, done.stderr)


def _not_audited(name: str, outcome: Outcome) -> Verdict:
    """Nothing was reached, or the audit itself failed."""
    complaint = outcome.errors.strip() or outcome.output.strip()
    reason = next((line for line in complaint.splitlines() if _UNREACHED.search(line)), "")
    if reason:
        return Verdict((f"{name}: {_NOBODY}", f"  {reason.strip()}"))
    return Verdict((f"{name} failed:", complaint), outcome.code or 1)


def _pip_advisories(dependencies: Sequence[Mapping[str, Any]]) -> Iterator[str]:
    for package in dependencies:
        for advisory in package.get("vulns", ()):
            mended = ", ".join(advisory.get("fix_versions", ())) or "no version yet"
            yield f"  {package['name']} {package['version']}: {advisory['id']}, mended in {mended}"


def _json(text: str) -> Mapping[str, Any]:
    try:
        value = json.loads(text)
    except ValueError:
        return {}
    return value if isinstance(value, dict) else {}


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
