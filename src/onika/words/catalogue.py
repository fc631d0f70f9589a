"""The catalogues of sentences: `text/LANGUAGE/DOMAIN.toml`, with a line `DOMAIN.name = "sentence"` for each.

A catalogue is read when its first sentence is wanted. The arguments of a sentence are the same in every language.
"""

import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files


@cache
def sentence(language: str, key: str) -> str:
    """The sentence of a key; raises KeyError where the language has none."""
    domain, _, name = key.partition(".")
    return sentences(language, domain)[name]


def sentences(language: str, domain: str) -> Mapping[str, str]:
    """The sentences of a domain by their names, none where the language has no such catalogue."""
    if domain in domains(language):
        return _read(language, domain)
    return {}


@cache
def domains(language: str) -> tuple[str, ...]:
    """The domains of a language that have a catalogue, in order."""
    folder = files("onika.words").joinpath("text", language)
    return tuple(sorted(path.name.removesuffix(".toml") for path in folder.iterdir() if path.name.endswith(".toml")))


@cache
def _read(language: str, domain: str) -> Mapping[str, str]:
    path = files("onika.words").joinpath("text", language, f"{domain}.toml")
    table: Mapping[str, str] = tomllib.loads(path.read_text(encoding="utf-8"))[domain]
    return table
