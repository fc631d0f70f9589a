"""One rule for all sentences: each in every language, with the same arguments, used somewhere, and made with those."""

import ast
import functools
import re
from pathlib import Path

import pytest

from onika.words.catalogue import domains, sentences
from onika.words.sentence import LANGUAGES, gaps

ROOT = Path(__file__).parents[2]
TEXTS = ROOT / "src" / "onika" / "words" / "text"
CATALOGUES = [
    (language, domain) for language in LANGUAGES for domain in sorted({path.stem for path in TEXTS.glob("*/*.toml")})
]
FORMATTED = re.compile(r"=f[\"'].*\{[^{}]*:[^{}]*[efg]\}")
"""A line with an argument that is a formatted number."""
KEY = re.compile(r"""["'`]([a-z]+\.[a-z0-9_]+)["'`]""")


@functools.cache
def sources():
    python = [path for path in sorted((ROOT / "src" / "onika").rglob("*.py")) if "static" not in path.parts]
    page = [
        path
        for path in sorted((ROOT / "browser" / "src").rglob("*"))
        if path.suffix in (".ts", ".svelte") and ".gen." not in path.name
    ]
    return [(path, path.read_text(encoding="utf-8")) for path in (*python, *page)]


@functools.cache
def english():
    return {f"{domain}.{name}": text for domain in domains("en") for name, text in sentences("en", domain).items()}


def calls_of(source, maker="Reason.of"):
    """The calls `Reason.of(key, …)` of a file, or those of another maker of sentences."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and ast.unparse(node.func) == maker:
            yield node


def law_sentences():
    """What the control laws say, who know no catalogue: key, English and names of arguments of each sentence."""
    for path, source in sources():
        for call in calls_of(source, "LawSentence") if "laws" in path.parts else ():
            key, text = (ast.literal_eval(argument) for argument in call.args)
            yield key, text, {keyword.arg for keyword in call.keywords}


@functools.cache
def literal_calls():
    """Every call with a literal key: where, the key, and the names of its arguments, None if they come by **."""
    rows = []
    for path, source in sources():
        if path.suffix != ".py" or "Reason.of" not in source:
            continue
        for call in calls_of(source):
            names = {keyword.arg for keyword in call.keywords}
            if call.args and isinstance(call.args[0], ast.Constant):
                rows.append((f"{path.name}:{call.lineno}", call.args[0].value, None if None in names else names))
    return rows


@pytest.mark.parametrize(("language", "domain"), CATALOGUES)
def test_a_catalogue_has_one_table_of_sentences(language, domain):
    path = TEXTS / language / f"{domain}.toml"
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]
    assert all(line.startswith(f"{domain}.") for line in lines), "a line is `DOMAIN.name = …`"
    assert all(isinstance(text, str) and text for text in sentences(language, domain).values())


@pytest.mark.parametrize(("language", "domain"), CATALOGUES)
def test_every_sentence_is_in_every_language_with_the_same_arguments(language, domain):
    here, there = sentences(language, domain), sentences(LANGUAGES[0], domain)
    assert set(here) == set(there)
    assert {name: gaps(text) for name, text in here.items()} == {name: gaps(text) for name, text in there.items()}


def test_every_sentence_is_used():
    written = {key for _, source in sources() for key in KEY.findall(source)}
    assert set(english()) - written == set()


def test_every_key_that_a_reason_is_made_of_has_a_sentence():
    assert [(place, key) for place, key, _ in literal_calls() if key not in english()] == []


def test_a_reason_is_made_with_the_arguments_of_its_sentence():
    given = [(place, key, names) for place, key, names in literal_calls() if names is not None and key in english()]
    assert [(place, key, names) for place, key, names in given if names != gaps(english()[key])] == []
    assert given


def test_a_number_goes_into_a_sentence_as_a_number_and_gets_the_decimal_sign_of_its_language():
    formatted = [
        f"{path.name}:{call.lineno}"
        for path, source in sources()
        if path.suffix == ".py" and FORMATTED.search(source)
        for maker in ("Reason.of", "LawSentence")
        for call in calls_of(source, maker)
        for keyword in call.keywords
        for part in ast.walk(keyword.value)
        if isinstance(part, ast.FormattedValue) and re.search("[efg]'$", ast.unparse(part.format_spec or part))
    ]
    assert formatted == []


def test_the_laws_say_the_english_of_the_catalogue_with_its_arguments():
    said = {key: (text, names) for key, text, names in law_sentences()}
    assert said == {key: (text, gaps(text)) for key, text in english().items() if key.startswith("laws.")}
    assert len(said) == len(list(law_sentences())), "a sentence is written in one place"
