"""The puzzle file, `puzzle/NAME.puzzle`: a format of our own in the style of Appendix A (requirement G10)."""

from onika.files import name_rows
from onika.files.block_words import BlockWords
from onika.files.layout import carry_comments
from onika.files.line import FileLine, is_number, one_line, row, show_number
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED
from onika.model.puzzle import MOST_LEVEL, GoalWords, Puzzle
from onika.model.world import Names
from onika.words.condition import Condition
from onika.words.fault import Fault
from onika.words.reason import Reason
from onika.words.sentence import LANGUAGES

ENDING = ".puzzle"

_LONGEST_S = 3600.0
_MOST_ACTIONS = 10_000
_SLOTS = (
    KeywordSlot("VERSION"),
    KeywordSlot("TITLE", many=True),
    KeywordSlot("TASK", many=True),
    KeywordSlot("LEVEL"),
    KeywordSlot("PROGRAM", Need.OPTIONAL),
    KeywordSlot("EXPECT", many=True),
    KeywordSlot("GOAL", Need.OPTIONAL, many=True),
    KeywordSlot("ACTIONS", Need.OPTIONAL),
    KeywordSlot("SECONDS", Need.OPTIONAL),
    KeywordSlot("HINT", Need.OPTIONAL, many=True),
    KeywordSlot("SOLUTION", Need.OPTIONAL),
)


def read(text: str, name: str, place_file: str) -> tuple[Puzzle | None, tuple[Fault, ...]]:
    """The puzzle of a text; left out with any fault."""
    reading = TextReading(place_file, Reason.of("files.puzzle_left_out", name=name))
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    words = BlockWords(reading.lines, _SLOTS, reading)
    puzzle = Puzzle(
        name=name,
        titles=name_rows.read_names(words, "TITLE"),
        tasks=name_rows.read_names(words, "TASK"),
        level=_whole(words, "LEVEL", 1, MOST_LEVEL, 1),
        program=words.word("PROGRAM", Reason.of("files.name_of_program")),
        expectations=tuple(text for line in words.rows("EXPECT") if (text := _expectation(line, reading))),
        actions=_whole(words, "ACTIONS", 1, _MOST_ACTIONS, 0),
        seconds=_seconds(words),
        hints=_hints(words),
        solution=words.word("SOLUTION", Reason.of("files.name_of_program")),
        goals=_goals(words),
    )
    return (None if reading.broken else puzzle), reading.faults


def write(puzzle: Puzzle, former: str = "") -> str:
    """The text of a puzzle, with the comments of its former text."""
    parts = [row("VERSION", EXTENDED), "\n", name_rows.show_names(puzzle.titles, "TITLE")]
    parts += [name_rows.show_names(puzzle.tasks, "TASK"), row("LEVEL", str(puzzle.level))]
    parts += [row("PROGRAM", puzzle.program)] if puzzle.program else []
    parts += ["\n", *(row("EXPECT", text) for text in puzzle.expectations)]
    parts += [
        row("GOAL", str(goal.conditions), language, one_line(text))
        for goal in puzzle.goals
        for language, text in goal.words
    ]
    parts += [row("ACTIONS", str(puzzle.actions))] if puzzle.actions else []
    parts += [row("SECONDS", show_number(puzzle.seconds))] if puzzle.seconds else []
    parts += ["\n", *map(_show_hint, puzzle.hints)] if puzzle.hints else []
    parts += ["\n", row("SOLUTION", puzzle.solution)] if puzzle.solution else []
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _show_goal(goal: GoalWords) -> str:
    return "".join(row("GOAL", str(goal.conditions), language, one_line(text)) for language, text in goal.words)


def _show_hint(hint: Names) -> str:
    return "".join(row("HINT", language, one_line(text)) for language, text in hint)


def _hints(words: BlockWords) -> tuple[Names, ...]:
    """Each begins with a line of the language in which the first one begins."""
    hints: list[dict[str, str]] = []
    first = ""
    for line in words.rows("HINT"):
        language, _, text = line.text.partition(" ")
        first = first or language
        is_new = language == first
        if language not in LANGUAGES or not text or (not is_new and language in hints[-1]):
            words.wrong_row(line, Reason.of("files.language_and_hint", languages=LANGUAGES))
        elif is_new:
            hints.append({language: text})
        else:
            hints[-1][language] = text
    return tuple(tuple(hint.items()) for hint in hints)


def _goals(words: BlockWords) -> tuple[GoalWords, ...]:
    """Each begins with a line in the language of the first; together they mean no more conditions than there are."""
    goals: list[tuple[int, dict[str, str]]] = []
    left, first = len(words.rows("EXPECT")), ""
    for line in words.rows("GOAL"):
        count, language, text = _goal_line(line)
        first = first or language
        if text and language == first and count <= left:
            left -= count
            goals.append((count, {language: text}))
        elif text and language != first and goals and goals[-1][0] == count and language not in goals[-1][1]:
            goals[-1][1][language] = text
        else:
            words.wrong_row(line, Reason.of("files.number_language_goal", languages=LANGUAGES))
    return tuple(GoalWords(count, tuple(texts.items())) for count, texts in goals)


def _goal_line(line: FileLine) -> tuple[int, str, str]:
    """How many conditions, language and words; no words where anything is wrong."""
    number, _, rest = line.text.partition(" ")
    language, _, text = rest.strip().partition(" ")
    is_number = number.isascii() and number.isdigit() and 0 < len(number) < 4 and int(number) > 0
    return (int(number), language, text.strip()) if is_number and language in LANGUAGES else (0, language, "")


def _expectation(line: FileLine, reading: TextReading) -> str:
    try:
        return Condition.parse(line.text).text
    except ValueError:
        reading.fault(line.number, Reason.of("files.kept_expect", line=str(line)))
        return ""


def _whole(words: BlockWords, keyword: str, least: int, most: int, default: int) -> int:
    meaning = Reason.of("files.whole_from_to", least=least, most=most)
    for line in words.rows(keyword)[:1]:
        if line.rest.isascii() and line.rest.isdigit() and len(line.rest) < 9 and least <= int(line.rest) <= most:
            return int(line.rest)
        words.wrong_row(line, meaning)
    return default


def _seconds(words: BlockWords) -> float:
    for line in words.rows("SECONDS")[:1]:
        if is_number(line.rest) and 0.0 < float(line.rest) <= _LONGEST_S:
            return float(line.rest)
        words.wrong_row(line, Reason.of("files.seconds_up_to", most=_LONGEST_S))
    return 0.0
