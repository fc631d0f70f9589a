"""The preference file, `.onika` (dissertation §A.5)."""

from onika.files.layout import carry_comments
from onika.files.line import FileLine, row
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import VERSION
from onika.model.preferences import STATUS_COLUMNS, Preferences, Window, WindowCorner
from onika.words.fault import Fault
from onika.words.reason import Reason

NAME = ".onika"

# The format of §A.5 prints STEPWISE where its text says STEPSIZE three times; STEPSIZE is written, both are read.
_KEYWORDS = (
    *("VERSION", "LINELEN", "MINSIZE", "MINPINSEP", "STEPSIZE", "PINLENGTH", "CONNSEP"),
    *("INCONST", "OUTCONST", "INVAR", "OUTVAR", "LOCISIZE", "HITTOL", "RATE"),
    *("LEXI", "CONF", "STAT", "LOCUS", "DICT", "APPL", "MAIN", "BUTTON", "STATINFO"),
)
_SLOTS = tuple(KeywordSlot(keyword, Need.OPTIONAL) for keyword in _KEYWORDS)


def read(text: str, name: str, place_file: str) -> tuple[Preferences, tuple[Fault, ...]]:
    """The preferences of a text; what is missing or wrong has its default, so there always are some.

    `name` completes the form of all formats.
    """
    reading = TextReading(place_file, Reason.of("files.defaults_stand", name=name))
    reading.open_versioned(text)
    if reading.is_over:
        return Preferences(), reading.faults
    lines = [FileLine(at.number, "STEPSIZE", at.rest) if at.keyword == "STEPWISE" else at for at in reading.lines]
    line = {
        key: lines_of_key[0] if lines_of_key else None for key, lines_of_key in reading.arrange(lines, _SLOTS).items()
    }
    default = Preferences()
    preferences = Preferences(
        line_length=reading.whole(line["LINELEN"], default.line_length, low=1),
        min_size=reading.whole(line["MINSIZE"], default.min_size, low=1),
        min_pin_separation=reading.whole(line["MINPINSEP"], default.min_pin_separation, low=1),
        step_size=reading.whole(line["STEPSIZE"], default.step_size, low=1),
        pin_length=reading.whole(line["PINLENGTH"], default.pin_length, low=1),
        connection_separation=reading.whole(line["CONNSEP"], default.connection_separation, low=1),
        show_inconst=reading.yes(line["INCONST"], default.show_inconst),
        show_outconst=reading.yes(line["OUTCONST"], default.show_outconst),
        show_invar=reading.yes(line["INVAR"], default.show_invar),
        show_outvar=reading.yes(line["OUTVAR"], default.show_outvar),
        locus_size=reading.whole(line["LOCISIZE"], default.locus_size, low=1),
        hit_tolerance=reading.whole(line["HITTOL"], default.hit_tolerance, low=1),
        shows_period=reading.choice(line["RATE"], {"frequency": False, "period": True}, default.shows_period),
        library=_window(line["LEXI"], default.library, reading),
        canvas=_window(line["CONF"], default.canvas, reading),
        status=_spot(line["STAT"], default.status, reading),
        variables=_spot(line["LOCUS"], default.variables, reading),
        dictionary=_window(line["DICT"], default.dictionary, reading),
        workspace=_window(line["APPL"], default.workspace, reading),
        main=_spot(line["MAIN"], default.main, reading),
        buttons=_spot(line["BUTTON"], default.buttons, reading),
        status_columns=_columns(line["STATINFO"], default.status_columns, reading),
    )
    return preferences, reading.faults


def write(preferences: Preferences, former: str = "") -> str:
    """The text of preferences, with the comments of its former text."""
    of = preferences
    rows = [
        row("VERSION", VERSION),
        "\n",
        row("LINELEN", str(of.line_length)),
        row("MINSIZE", str(of.min_size)),
        row("MINPINSEP", str(of.min_pin_separation)),
        row("STEPSIZE", str(of.step_size)),
        row("PINLENGTH", str(of.pin_length)),
        row("CONNSEP", str(of.connection_separation)),
        row("INCONST", _yes(of.show_inconst)),
        row("OUTCONST", _yes(of.show_outconst)),
        row("INVAR", _yes(of.show_invar)),
        row("OUTVAR", _yes(of.show_outvar)),
        row("LOCISIZE", str(of.locus_size)),
        row("HITTOL", str(of.hit_tolerance)),
        row("RATE", "period" if of.shows_period else "frequency"),
        row("LEXI", *_place(of.library)),
        row("CONF", *_place(of.canvas)),
        row("STAT", *_place(of.status)),
        row("LOCUS", *_place(of.variables)),
        row("DICT", *_place(of.dictionary)),
        row("APPL", *_place(of.workspace)),
        row("MAIN", *_place(of.main)),
        row("BUTTON", *_place(of.buttons)),
        row("STATINFO", *of.status_columns),
        "\n",
        row("EOF"),
    ]
    return carry_comments(former, "".join(rows))


def _yes(shown: bool) -> str:
    return "yes" if shown else "no"


def _place(place: WindowCorner | Window) -> tuple[str, ...]:
    size = (place.height, place.width) if isinstance(place, Window) else ()
    return tuple(map(str, (place.x, place.y, *size)))


def _spot(line: FileLine | None, default: WindowCorner, reading: TextReading) -> WindowCorner:
    return WindowCorner(*reading.wholes(line, (default.x, default.y)))


def _window(line: FileLine | None, default: Window, reading: TextReading) -> Window:
    window = Window(*reading.wholes(line, (default.x, default.y, default.height, default.width)))
    if line and min(window.height, window.width) < 1:
        reading.fault(line.number, Reason.of("files.height_and_width", keyword=line.keyword, line=str(line)))
        return default
    return window


def _columns(line: FileLine | None, default: tuple[str, ...], reading: TextReading) -> tuple[str, ...]:
    if line is None:
        return default
    is_valid = set(line.words) <= set(STATUS_COLUMNS) and len(set(line.words)) == len(line.words)
    if not is_valid:
        reading.fault(line.number, Reason.of("files.columns", columns=" ".join(STATUS_COLUMNS), line=str(line)))
    return line.words if is_valid else default
