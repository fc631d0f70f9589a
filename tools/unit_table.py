"""The units that people prefer as TypeScript."""

import json

from onika.words.unit import RATES, UNITS

_HEAD = "// Drawn from src/onika/words/unit.py by tools/generate.py: change that.\n"


def source() -> str:
    """The whole file."""
    units = json.dumps(UNITS, indent=2)
    rates = json.dumps(RATES)
    return (
        f"{_HEAD}export const UNITS: Readonly<Record<string, Readonly<Record<string, number>>>> = {units};\n"
        f"export const RATES: readonly string[] = {rates};\n"
    )
