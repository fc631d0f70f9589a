"""Reading an application from text in the words of AL (requirement D14, dissertation §4.4)."""

from onika.files import appl
from onika.files.al import where_section
from onika.files.al.logical_line import sentences
from onika.files.al.program import TextProgram
from onika.files.al.where_section import Dictionary
from onika.files.text_reading import TextReading
from onika.model.application import Application
from onika.model.syntax import Syntax
from onika.words.fault import Fault
from onika.words.reason import Reason

ENDING = ".al"

_LONGEST = 1_000_000
"""Letters of a text; one of ten thousand actions has half of them."""


def read(
    text: str, name: str, place_file: str, syntax: Syntax, dictionary: Dictionary = lambda _: None
) -> tuple[Application | None, tuple[Fault, ...]]:
    """The application `name` of a text; left out with any fault.

    Its icons are those of the text's own section WHERE, else those of `dictionary`, with the values the text gives.
    Comments mean nothing. What is read is what its `.appl` says: marks of targets are those of their jobs.
    """
    reading = TextReading(place_file, Reason.of("files.application_left_out"))
    text = text.removeprefix("\ufeff")
    if len(text) > _LONGEST:
        reading.fault(0, Reason.of("files.text_long", most=_LONGEST, count=len(text)))
        return None, reading.faults
    statements, start = sentences(text, reading)
    where = where_section.read(text, start, syntax, dictionary, reading)
    program = TextProgram(syntax, where, reading)
    for sentence in statements:
        if reading.is_full:
            break
        program.take(sentence)
    flows = program.end()
    if reading.broken or flows is None:
        return None, reading.faults
    application = Application(name, program.is_parallel, flows)
    settled, faults = appl.read(appl.write(application), name, place_file, syntax)
    if settled is None:
        for fault in faults:
            reading.fault(0, fault.reason)
    return settled, reading.faults
