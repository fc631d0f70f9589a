"""Writes logs as the diary does, event by event, with the times that a test says."""

from dataclasses import dataclass, field

from onika.files.state import session_log

HEAD = "time\tevent\tobject\tid\tassociated\tassociated_id\twindow"
BEGIN_S = 1_790_000_000.0
ICONS = ("opengripC", "jmoveC", "box2_aj", "cmoveC", "box2_bx", "closegripC", "box1_aj", "box2_ex")


@dataclass
class LogText:
    """A log that grows; every method lets `after` seconds pass, then an event happens."""

    at_s: float = BEGIN_S
    lines: list[str] = field(default_factory=lambda: [HEAD])
    step: int = 0

    def put(self, after: float, event: str, *words: str) -> "LogText":
        """Any event: object, id, associated, its id, window."""
        self.at_s = round(self.at_s + after, 3)
        columns = [*words, "none", "0", "none", "0", "root"][:5] if not words else list(words)
        self.lines.append("\t".join((f"{self.at_s:.3f}", event, *columns)))
        return self

    def start(self) -> "LogText":
        """The environment has begun."""
        return self.put(0.0, "Start_Onika")

    def quit(self) -> "LogText":
        """It has ended."""
        return self.put(1.0, "Quit_Onika")

    def new(self, after: float = 5.0) -> "LogText":
        """A new application."""
        return self.put(after, "new_appl", "Untitled-1", "a1", "none", "0", "appl")

    def select(self, after: float, icon: str = "jmoveC") -> "LogText":
        """An icon is selected in the dictionary."""
        return self.put(after, "select_icon", icon, icon, "none", "0", "dict")

    def insert(self, after: float, icon: str = "jmoveC") -> "LogText":
        """An icon is put into the application."""
        self.step += 1
        return self.put(after, "insert_icon", icon, f"a1/{self.step}", "Start", "a1/0", "appl")

    def delete(self, after: float, *steps: int) -> "LogText":
        """Icons are deleted."""
        names, ids = ",".join("jmoveC" for _ in steps), ",".join(f"a1/{step}" for step in steps)
        return self.put(after, "delete_icon", names, ids, "Untitled-1", "a1", "appl")

    def run(self, after: float, lasts: float, cause: str = "completed") -> "LogText":
        """The application is run to its end."""
        self.put(after, "run_appl", "Untitled-1", "a1", "none", "0", "appl")
        return self.put(lasts, "end_appl", "Untitled-1", "a1", cause, "1", "appl")

    @property
    def text(self) -> str:
        """The log."""
        return "\n".join(self.lines) + "\n"


def with_records(text: str, session: str = "5e55") -> str:
    """A log of seven columns as the diary writes it: with a record and a check behind each line."""
    rows = [line.split("\t") for line in text.splitlines()[1:]]
    lines = [session_log.line(row, f'{{"s":"{session}","n":{number}}}') for number, row in enumerate(rows)]
    return "\n".join((session_log.HEADER, *lines)) + "\n"


def assembly(selection_s: float, icons: int = 12, insertion_s: float = 2.0, begin_s: float = BEGIN_S) -> str:
    """A task without a detour: each selection takes `selection_s`, plus and minus a quarter in turn."""
    log = LogText(begin_s).start().new()
    for number in range(icons):
        icon = ICONS[number % len(ICONS)]
        log.select(selection_s * (1.25 if number % 2 else 0.75), icon).insert(insertion_s, icon)
    return log.run(10.0, 20.0).quit().text
