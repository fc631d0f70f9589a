"""The catalogues of sentences as TypeScript. English needs none: every reason brings its English sentence."""

import json

from onika.words.catalogue import domains, sentences

_HEAD = "// Drawn from src/onika/words/text/{language}/*.toml by tools/generate.py: change those.\n"


def source(language: str) -> str:
    """The file of one language."""
    keys = {
        f"{domain}.{name}": text for domain in domains(language) for name, text in sentences(language, domain).items()
    }
    lines = [f"  {json.dumps(key)}: {json.dumps(text, ensure_ascii=False)}," for key, text in sorted(keys.items())]
    head = _HEAD.format(language=language)
    return "\n".join((head + "export const catalogue: Readonly<Record<string, string>> = {", *lines, "}", ""))
