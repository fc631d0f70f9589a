"""Builds flows from the statements of an AL text, block by block (§4.4)."""

from collections import Counter
from collections.abc import Callable

from onika.files.al import action_statement
from onika.files.al.block import ENDS, Block, LoopMark, marked
from onika.files.al.logical_line import Statement, Token
from onika.files.al.token_stream import TokenStream
from onika.files.al.where_section import WhereSection
from onika.files.flow import DEEPEST
from onika.files.text_reading import TextReading
from onika.model.application import AppFlow, Icon, Step
from onika.model.syntax import Syntax
from onika.words.reason import Reason, reason_of

_TWO = ("END IF", "END WHILE", "END CASE", "CASE OF")
_CLOSES = {end: kind for kind, end in ENDS.items()}
_MIDDLE = {"ELSEIF": "IF", "ELSE": "IF", "DO": "WHILE"}
_STATEMENT = "statement"


class TextProgram:
    """The blocks that are open while sentences come, and the whole once all are closed."""

    def __init__(self, syntax: Syntax, where_section: WhereSection, reading: TextReading) -> None:
        self._syntax = syntax
        self._glossary = where_section
        self._reading = reading
        self._open: list[Block] = []
        self._kinds: Counter[str] = Counter()
        self._flows: tuple[AppFlow, ...] | None = None
        self._has_more = False
        self.is_parallel = False

    def take(self, sentence: Statement) -> None:
        """One sentence; what is wrong with it is reported, and the next one may come."""
        try:
            self._take(sentence)
        except ValueError as error:
            self._reading.fault(sentence.number, reason_of(error))

    def end(self) -> tuple[AppFlow, ...] | None:
        """The flows of the program, where it was whole; what is lacking at its end is reported."""
        if not self._open and self._flows is None and not self._reading.broken:
            self._reading.fault(self._reading.end, Reason.of("files.text_empty"))
        while self._open:
            self._unclosed(self._pop(), self._reading.end, Reason.of("files.end_of_program"))
        return self._flows

    # -- one sentence

    def _take(self, sentence: Statement) -> None:
        form = _form(sentence.tokens)
        if form in _CLOSES or form in _MIDDLE:
            self._reach(_CLOSES.get(form) or _MIDDLE[form], form, sentence)
            self._close(form, sentence) if form in _CLOSES else self._divide(form, sentence)
            return
        if self._flows is not None:
            if not self._has_more:
                self._reading.fault(sentence.number, Reason.of("files.behind_program", sentence=str(sentence)))
            self._has_more = True
            return
        if form in ENDS:
            self._begin(form, sentence)
            return
        block = self._inner(sentence)
        if form == _STATEMENT:
            self._statement(block, sentence)
        elif form in _MARKS:
            _MARKS[form](block, sentence)
        else:
            heads = (*action_statement.HEADS, *_MARKS, *ENDS, *_CLOSES)
            raise ValueError(Reason.of("files.word_of_language", words=" ".join(heads), sentence=str(sentence)))

    def _statement(self, block: Block, sentence: Statement) -> None:
        try:
            steps = action_statement.read(sentence, self._glossary, self._syntax)
        except ValueError:
            block.lose()
            raise
        if not isinstance(steps[0], Icon):
            self._check_waiting(block)
        block.add(steps)

    def _inner(self, sentence: Statement) -> Block:
        """The block in which statements may stand; where its BEGIN is lacking, that is reported once."""
        if not self._open or self._open[-1].holds_flows:
            self._reading.fault(
                sentence.number,
                Reason.of("files.begin_expected", sentence=str(sentence))
                if self._open
                else Reason.of("files.program_expected", sentence=str(sentence)),
            )
            self._push(Block("BEGIN", sentence, is_implied=True))
        return self._open[-1]

    # -- blocks

    def _begin(self, form: str, sentence: Statement) -> None:
        self._check_place(form, sentence)
        phrase = TokenStream(sentence, len(form.split()))
        is_branch = form == "IF" or (form == "CASE OF" and bool(self._open))
        outer_depth = self._open[-1].depth if self._open else 0
        block = Block(form, sentence, depth=outer_depth + is_branch)
        if is_branch and block.depth == DEEPEST + 1:
            self._reading.fault(sentence.number, Reason.of("files.branches_too_deep", deepest=DEEPEST))
        self._push(block)  # before its words are read, so that its end finds it whatever they are
        if form == "IF":
            block.conditions.append(phrase.condition("THEN"))
        elif form in ("WHILE", "REPEAT"):
            block.tag = phrase.tag()
        phrase.end()

    def _check_place(self, form: str, sentence: Statement) -> None:
        """Refuse a block where it may not begin; one among statements lets no mark wait for an action."""
        match form:
            case "BEGIN":
                if self._open and not self._open[-1].holds_flows:
                    raise ValueError(Reason.of("files.begin_misplaced", sentence=str(sentence)))
            case "COBEGIN":
                if self._open:
                    raise ValueError(Reason.of("files.cobegin_misplaced", sentence=str(sentence)))
            case "CASE OF" if not self._open:
                pass  # the flows of the whole program
            case _:
                self._check_waiting(self._inner(sentence))

    def _reach(self, kind: str, form: str, sentence: Statement) -> None:
        """Close what is open within the block that a sentence ends or divides."""
        if not self._kinds[kind]:
            raise ValueError(Reason.of("files.none_open", kind=kind, form=form))
        while self._open[-1].kind != kind:
            self._unclosed(self._pop(), sentence.number, str(sentence))

    def _push(self, block: Block) -> None:
        self._open.append(block)
        self._kinds[block.kind] += 1

    def _pop(self) -> Block:
        block = self._open.pop()
        self._kinds[block.kind] -= 1
        return block

    def _unclosed(self, block: Block, number: int, opening: Reason | str) -> None:
        self._check_waiting(block)
        if block.kind == "BEGIN" and self._open:
            self._open[-1].flows.append(block.flow())
        if not block.is_implied:
            self._reading.fault(
                number,
                Reason.of(
                    "files.block_end",
                    ends=ENDS[block.kind],
                    opened=str(block.opened),
                    number=block.opened.number,
                    given=opening,
                ),
            )

    def _divide(self, form: str, sentence: Statement) -> None:
        block = self._open[-1]
        self._check_waiting(block)
        phrase = TokenStream(sentence, 1)
        if block.is_last:
            raise ValueError(Reason.of("files.end_expected", ends=ENDS[block.kind], sentence=str(sentence)))
        block.is_last = form != "ELSEIF"
        block.takes_break = False
        if form == "DO":
            block.tests, block.items = block.items, []
            block.condition = phrase.condition() if phrase.takes("IF") else ""
        else:
            block.end_part()
            if form == "ELSEIF":
                block.conditions.append("")  # stands for it, should it be wrong
                block.conditions[-1] = phrase.condition("THEN")
        phrase.end()

    def _close(self, form: str, sentence: Statement) -> None:
        block = self._pop()
        self._check_waiting(block)
        phrase = TokenStream(sentence, len(form.split()))
        outer = self._open[-1] if self._open else None
        if outer:
            outer.takes_break = False
        if block.kind == "BEGIN":
            phrase.end()
            self._finish((block.flow(),), is_parallel=False) if outer is None else outer.flows.append(block.flow())
        elif block.kind == "COBEGIN" or (block.kind == "CASE OF" and outer is None):
            phrase.end()
            self._check_flows(block, sentence)
            self._finish(tuple(block.flows), is_parallel=block.kind == "COBEGIN")
        elif outer is not None:
            self._close_inner(block, outer, sentence, phrase)

    def _close_inner(self, block: Block, outer: Block, sentence: Statement, phrase: TokenStream) -> None:
        if block.kind in ("WHILE", "REPEAT"):
            outer.items += self._looped(block, sentence, phrase)
        else:
            if block.kind == "IF":
                block.end_part()
                if not block.is_last:
                    block.end_part()
            else:
                self._check_flows(block, sentence)
            outer.items.append([block.branch()])
        phrase.end()

    def _looped(self, block: Block, sentence: Statement, phrase: TokenStream) -> list[list[Step]]:
        """The statements of a loop, with its tag on the first and the last."""
        if block.kind == "REPEAT":
            condition = phrase.condition() if phrase.takes("NOT") else ""
            if not condition and not phrase.takes("DONE"):
                raise ValueError(Reason.of("files.until_condition", rest=phrase.rest()))
            if len(block.items) < 2:
                reason = Reason.of("files.repeat_statements", tag=block.tag, count=len(block.items))
                self._reading.fault(block.opened.number, reason)
                return block.items
            self._mark(block.items, 0, block, Reason.of("files.first"))
            self._mark(block.items, -1, block, Reason.of("files.last"), is_test=True, condition=condition)
            return block.items
        if not block.is_last:
            raise ValueError(Reason.of("files.do_before_end_while", sentence=str(sentence)))
        if len(block.tests) != 1:
            reason = Reason.of("files.while_statements", tag=block.tag, count=len(block.tests))
            self._reading.fault(block.opened.number, reason)
        else:
            self._mark(block.tests, 0, block, Reason.of("files.first"), is_test=True, condition=block.condition)
        self._mark(block.items, -1, block, Reason.of("files.last_behind_do"))
        return [*block.tests, *block.items]

    def _mark(
        self,
        items: list[list[Step]],
        at: int,
        block: Block,
        where: Reason,
        *,
        is_test: bool = False,
        condition: str = "",
    ) -> None:
        steps = marked(items, at, block.tag, is_test=is_test, condition=condition)
        if steps:
            self._reading.fault(
                block.opened.number, Reason.of("files.loop_tagged", where=where, tag=block.tag, given=steps)
            )

    def _finish(self, flows: tuple[AppFlow, ...], *, is_parallel: bool) -> None:
        self._flows, self.is_parallel = flows, is_parallel

    def _check_flows(self, block: Block, sentence: Statement) -> None:
        if not block.flows:
            self._reading.fault(sentence.number, Reason.of("files.begin_end_within", kind=block.kind))

    def _check_waiting(self, block: Block) -> None:
        """Report marks that no action follows."""
        waiting = [block.synch[0]] if block.synch else []
        waiting += [block.loop_mark.sentence] if block.loop_mark else []
        for sentence in waiting:
            self._reading.fault(sentence.number, Reason.of("files.action_next_line", sentence=str(sentence)))
        block.synch = block.loop_mark = None


def _form(tokens: tuple[Token, ...]) -> str:
    """The word or two with which a sentence begins; DO alone or before IF divides a loop, else it is a verb."""
    first = tokens[0].value if tokens[0].kind == "word" else ""
    second = tokens[1].value if len(tokens) > 1 and tokens[1].kind == "word" else ""
    if f"{first} {second}" in _TWO:
        return f"{first} {second}"
    if first in action_statement.HEADS and not (first == "DO" and (second == "IF" or len(tokens) == 1)):
        return _STATEMENT
    return first


def _synch(block: Block, sentence: Statement) -> None:
    phrase = TokenStream(sentence, 1)
    tag = phrase.tag()
    phrase.end()
    if block.synch:
        raise ValueError(Reason.of("files.one_synch", sentence=str(sentence)))
    block.synch, block.takes_break = (sentence, tag), False


def _tag(block: Block, sentence: Statement) -> None:
    phrase = TokenStream(sentence, 1)
    tag = phrase.tag()
    is_test = bool(phrase.takes("TEST"))
    condition = phrase.condition() if phrase.takes("IF") else ""
    phrase.end()
    if block.loop_mark:
        raise ValueError(Reason.of("files.one_tag", sentence=str(sentence)))
    block.loop_mark, block.takes_break = LoopMark(sentence, tag, is_test, condition), False


def _break(block: Block, sentence: Statement) -> None:
    phrase = TokenStream(sentence, 1)
    is_off = bool(phrase.takes("OFF"))
    condition = phrase.condition() if phrase.takes("IF") else ""
    phrase.end()
    if is_off and not condition:
        raise ValueError(Reason.of("files.break_off_if", sentence=str(sentence)))
    if not block.takes_break:
        raise ValueError(Reason.of("files.action_before_break", sentence=str(sentence)))
    block.rest(condition, is_off=is_off)


_MARKS: dict[str, Callable[[Block, Statement], None]] = {"SYNCH": _synch, "TAG": _tag, "BREAK": _break}
