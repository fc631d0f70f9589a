"""Writing an application as text in the words of AL (requirement D14, dissertation §4.4)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from onika.files.al import token, verb
from onika.files.al.loops import LoopBlock, loops
from onika.files.al.where_section import Dictionary, WhereSection
from onika.files.line import one_line
from onika.model.application import AppFlow, Application, Branch, Hole, Icon, Step, actions
from onika.model.onikon import Onikon
from onika.model.syntax import DataItem, Syntax
from onika.words.value import Value

WIDTH = 120
_STEP = "  "


def write(application: Application, syntax: Syntax, dictionary: Dictionary = lambda _: None) -> str:
    """The text of an application; icons that `dictionary` holds alike are named only, all others defined at the end.

    Raises ValueError for a text value with signs that no line holds.
    """
    return _Writing(syntax, WhereSection(dictionary)).text(application)


@dataclass(frozen=True, slots=True)
class _Statement:
    """Steps that stand on one line: an action with its targets, or a single step."""

    steps: tuple[Step, ...]

    @property
    def head(self) -> Icon | None:
        first = self.steps[0]
        return first if isinstance(first, Icon) else None


class _Writing:
    """The lines of a text as they grow."""

    def __init__(self, syntax: Syntax, glossary: WhereSection) -> None:
        self._syntax = syntax
        self._glossary = glossary
        self._lines: list[str] = []
        self._depth = 0
        self._described: set[tuple[str, str]] = set()

    def text(self, application: Application) -> str:
        self._line(f"{{ {_remark(application.name)} }}")
        if application.is_parallel:
            self._blocks("COBEGIN", application.flows, "COEND")
        elif len(application.flows) == 1:
            self._block(application.flows[0])
        else:
            self._blocks("CASE OF", application.flows, "END CASE")
        where = self._glossary.write()
        return "".join(f"{line}\n" for line in self._lines) + (f"\n{where}" if where else "")

    # -- blocks

    def _blocks(self, head: str, flows: Sequence[AppFlow], end: str) -> None:
        self._line(head)
        self._depth += 1
        for number, flow in enumerate(flows):
            self._block(flow, f" {{ flow {number} }}")
        self._depth -= 1
        self._line(end)

    def _block(self, flow: AppFlow, remark: str = "") -> None:
        self._line(f"BEGIN{remark}")
        self._inside(flow)
        self._line("END")

    def _inside(self, flow: AppFlow) -> None:
        self._depth += 1
        statements = _statements(flow, self._syntax)
        blocks = loops([statement.head for statement in statements])
        begins = {loop.first: loop for loop in blocks}
        ends = {loop.last: loop for loop in blocks}
        for at, statement in enumerate(statements):
            loop = begins.get(at) or ends.get(at)
            if at in begins:
                self._line(f"{'WHILE' if begins[at].tests_first else 'REPEAT'} {token.show(begins[at].tag)}")
                self._depth += 1
            self._statement(statement, loop)
            if at in begins and begins[at].tests_first:
                self._outdented("DO" + _when(" IF", begins[at].condition))
            if at in ends:
                self._depth -= 1
                self._line(_closing(ends[at]))
        self._depth -= 1

    def _branch(self, branch: Branch) -> None:
        if not branch.conditions:
            self._blocks("CASE OF", branch.flows, "END CASE")
            return
        heads = [f"ELSEIF {_condition(condition)} THEN" for condition in branch.conditions]
        heads[0] = heads[0].removeprefix("ELSE")
        *chosen, other = branch.flows
        for head, flow in zip(heads, chosen, strict=True):
            self._line(head)
            self._inside(flow)
        if other.steps:
            self._line("ELSE")
            self._inside(other)
        self._line("END IF")

    # -- statements

    def _statement(self, statement: _Statement, loop: LoopBlock | None) -> None:
        first = statement.steps[0]
        if isinstance(first, Branch):
            self._branch(first)
            return
        if isinstance(first, Hole):
            self._line(self._hole(first))
            return
        if first.synch_tag is not None:
            self._line(f"SYNCH {token.show(first.synch_tag)}")
        if first.while_tag is not None and loop is None:
            test = " TEST" if first.while_test else ""
            self._line(f"TAG {token.show(first.while_tag)}{test}{_when(' IF', first.while_if)}")
        self._said(statement)
        if first.marker or first.marker_if:
            self._line("BREAK" + ("" if first.marker else " OFF") + _when(" IF", first.marker_if))

    def _said(self, statement: _Statement) -> None:
        """The line of an action or a target, with a remark where an icon is new."""
        words: list[str] = []
        is_first = True
        for at, step in enumerate(statement.steps):
            if isinstance(step, Hole):
                words += [verb.PREPOSITIONS[0 if is_first else -1], self._hole(step)]
            elif isinstance(step, Icon) and (at or self._is_target(step)):
                words += [verb.preposition(step.onikon, is_first), *self._target(step.onikon)]
            elif isinstance(step, Icon):
                words.append(self._action(step.onikon))
                continue
            is_first = False
        icons = [step.onikon for step in statement.steps if isinstance(step, Icon)]
        described = dict.fromkeys((icon.name, icon.description) for icon in icons if icon.description)
        new = [description for description in described if description not in self._described]
        self._described.update(new)
        remark = "; ".join(description for _, description in new)
        self._wrapped(words, f"{{ {_remark(remark)} }}" if remark else "")

    def _action(self, onikon: Onikon) -> str:
        called = verb.verb(onikon, self._syntax)
        hand = " HAND" if called in verb.HANDS else ""
        return f"{called}{hand} {self._glossary.refer(onikon)}"

    def _is_target(self, icon: Icon) -> bool:
        kind = self._syntax.find(icon.onikon.type)
        return kind is not None and kind.is_target

    def _target(self, onikon: Onikon) -> list[str]:
        """Its name and its values, in pieces that a line may be broken between."""
        kind = self._syntax.find(onikon.type)
        items = kind.items if kind else ()
        pieces = [self._glossary.refer(onikon)]
        groups = [list(_values(item, values)) for item, values in zip(items, onikon.values, strict=False)]
        for group in groups[:-1]:
            group[-1] += ";"
        values = [piece for group in groups for piece in group]
        if values:
            values[0] = "(" + values[0]
            values[-1] += ")"
        return pieces + values

    def _hole(self, hole: Hole) -> str:
        return "HOLE" + self._glossary.refer_hole(hole.kept)

    # -- lines

    def _line(self, text: str) -> None:
        self._lines.append(_STEP * self._depth + text)

    def _outdented(self, text: str) -> None:
        self._depth -= 1
        self._line(text)
        self._depth += 1

    def _wrapped(self, words: Sequence[str], remark: str) -> None:
        """A statement on one line, or broken where it has parentheses; its remark behind it or on a line before."""
        lead = _STEP * self._depth
        lines = [lead + words[0]]
        is_within = False
        for piece in words[1:]:
            if is_within and len(lines[-1]) + 1 + len(piece) > WIDTH:
                lines.append(lead + _STEP * 2 + piece)
            else:
                lines[-1] += " " + piece
            is_within = not piece.endswith(")") and (is_within or piece.startswith("("))
        if remark and len(lines[-1]) + 2 + len(remark) <= WIDTH:
            lines[-1] += "  " + remark
        elif remark:
            lines.insert(0, lead + remark)
        self._lines += lines


def _statements(flow: AppFlow, syntax: Syntax) -> list[_Statement]:
    """The steps of a flow, those that belong together in one; a target with marks of its own stands alone."""
    ends = {action.position: action.end for action in actions(flow, syntax)}
    statements: list[_Statement] = []
    at = 0
    while at < len(flow.steps):
        end = ends.get(at, at + 1)
        if any(isinstance(step, Icon) and Icon(step.onikon) != step for step in flow.steps[at + 1 : end]):
            end = at + 1
        statements.append(_Statement(flow.steps[at:end]))
        at = end
    return statements


def _values(item: DataItem, values: Sequence[Value]) -> Iterator[str]:
    """The values of a data item; one alone has its name before it."""
    label = f"{item.name}=" if item.count == 1 and token.is_label(item.name) else ""
    for value in values:
        yield label + (token.quoted(value) if isinstance(value, str) else repr(value))


def _closing(loop: LoopBlock) -> str:
    if loop.tests_first:
        return "END WHILE"
    return "UNTIL" + (_when(" NOT", loop.condition) or " DONE")


def _when(lead: str, condition: str) -> str:
    if condition:
        return f"{lead} {_condition(condition)}"
    return ""


def _condition(text: str) -> str:
    """A condition as it is, or in quotes where its blanks would not be read again."""
    if text == " ".join(text.split()) and '"' not in text:
        return text
    return token.quoted(text)


def _remark(text: str) -> str:
    return one_line(text).replace("}", ")")
