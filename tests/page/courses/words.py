"""The words of the page, by key and language, as its sources have them."""

import re
from functools import cache
from pathlib import Path

_TEXTS = Path(__file__).parents[3] / "browser" / "src" / "texts"
_LINE = re.compile(r"""'([\w.]+)':\s*(?:'((?:[^'\\]|\\.)*)'|"((?:[^"\\]|\\.)*)")""")


@cache
def texts(language: str) -> dict[str, str]:
    """All of a language; of a sentence with a plural both forms, with `|` between them."""
    files = sorted(_TEXTS.glob(f"{language}.*.ts"))
    lines = (match for file in files for match in _LINE.finditer(file.read_text(encoding="utf-8")))
    return {key: (single or double).replace("\\'", "'") for key, single, double in (line.groups() for line in lines)}
