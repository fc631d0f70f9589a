"""Reads one statement of AL into steps: an action with its targets, a target by itself, or a hole."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from onika.files.al import token as word, verb
from onika.files.al.logical_line import Statement, Token, joined
from onika.files.al.token_stream import TokenStream
from onika.files.al.where_section import WhereSection
from onika.files.line import show
from onika.model.application import Hole, Icon
from onika.model.onikon import Onikon
from onika.model.syntax import DataItem, IconType, Syntax
from onika.words.reason import Reason
from onika.words.value import Value

HEADS = (*verb.VERBS, *verb.PREPOSITIONS, "HOLE")
"""The words a statement begins with."""


def read(sentence: Statement, glossary: WhereSection, syntax: Syntax) -> list[Icon | Hole]:
    """Its steps, at least one; raises ValueError "expected …, found …" for a sentence that is no statement."""
    phrase = TokenStream(sentence)
    number = sentence.number
    steps: list[Icon | Hole] = []
    if phrase.takes("HOLE"):
        steps.append(_hole(phrase, glossary, number))
    else:
        if called := phrase.takes(*verb.VERBS):
            steps.append(Icon(_action(called, phrase, glossary, syntax), line=number))
        while phrase.takes(*verb.PREPOSITIONS):
            is_hole = phrase.takes("HOLE")
            steps.append(
                _hole(phrase, glossary, number) if is_hole else Icon(_target(phrase, glossary, syntax), line=number)
            )
    if not steps:
        raise ValueError(Reason.of("files.heads_expected", heads=tuple(HEADS), rest=phrase.rest()))
    phrase.end()
    return steps


def _action(called: str, phrase: TokenStream, glossary: WhereSection, syntax: Syntax) -> Onikon:
    if called in verb.HANDS:
        phrase.takes("HAND")
    onikon = _found(phrase, Reason.of("files.name_of_job_or_application"), glossary)
    fitting = verb.verb(onikon, syntax)
    kind = syntax.find(onikon.type)
    if kind and kind.is_target:
        raise ValueError(Reason.of("files.action_after", called=called, name=onikon.name, type=onikon.type))
    if called not in (fitting, verb.ANY):
        raise ValueError(
            Reason.of("files.target_too_many", fitting=fitting, name=onikon.name, type=onikon.type, called=called)
        )
    return onikon


def _target(phrase: TokenStream, glossary: WhereSection, syntax: Syntax) -> Onikon:
    onikon = _found(phrase, Reason.of("files.name_of_target"), glossary)
    kind = syntax.find(onikon.type)
    if kind is None or not kind.is_target:
        raise ValueError(Reason.of("files.target_expected", name=onikon.name, type=onikon.type))
    if not phrase.takes("("):
        return onikon
    return replace(onikon, values=tuple(_values(phrase, kind)))


def _hole(phrase: TokenStream, glossary: WhereSection, number: int) -> Hole:
    at = phrase.rest()
    variant = phrase.variant(default=0)
    if variant and variant not in glossary.holes:
        raise ValueError(Reason.of("files.hole_under_where", variant=variant, at=at))
    return Hole(number, glossary.holes[variant] if variant else "")


def _found(phrase: TokenStream, meaning: Reason, glossary: WhereSection) -> Onikon:
    name = phrase.name(meaning, word.KEYWORDS)
    variant = phrase.variant()
    onikon = glossary.find(name, variant)
    if onikon is None:
        shown = name if variant == 1 else f"{name} #{variant}"
        where = "files.in_dictionary_or_where" if variant == 1 else "files.under_where"
        raise ValueError(Reason.of("files.icon_unknown", shown=shown, where=Reason.of(where)))
    return onikon


def _values(phrase: TokenStream, kind: IconType) -> Iterator[tuple[Value, ...]]:
    """The values of a target between its parentheses, data item by data item."""
    for at, item in enumerate(kind.items):
        if at and not phrase.takes(";"):
            raise ValueError(Reason.of("files.more_values", what=_what(item), rest=phrase.rest()))
        yield _item(phrase, item)
    if not phrase.takes(")"):
        raise ValueError(Reason.of("files.behind_values", name=kind.name, rest=phrase.rest()))


def _item(phrase: TokenStream, item: DataItem) -> tuple[Value, ...]:
    left = phrase.left
    if len(left) > 1 and left[1].says("="):
        label = phrase.token(Reason.of("files.name_of_item"), "word", "text").value
        if label != item.name:
            raise ValueError(Reason.of("files.no_name", name=item.name, label=show(label + "=")))
        phrase.takes("=")
    tokens: list[Token] = []
    while phrase.left and not phrase.left[0].says(";", ")"):
        tokens.append(phrase.token(_what(item), "word", "text"))
    if not item.takes(len(tokens)):
        raise ValueError(Reason.of("files.values_expected", what=_what(item), given=_given(tokens, phrase)))
    return tuple(item.type.parse(token.value) for token in tokens)


def _given(tokens: Sequence[Token], phrase: TokenStream) -> Reason:
    if not tokens:
        return Reason.of("files.none_before", rest=phrase.rest())
    return Reason.of("files.count_in", count=len(tokens), given=show(joined(tokens)))


def _what(item: DataItem) -> Reason:
    return Reason.of("files.elements_for", count=item.count, type=item.type.value, name=item.name)
