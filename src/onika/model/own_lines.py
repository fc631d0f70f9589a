"""What a configuration says of a placed task otherwise than its file: aliases and parameters (requirement B09)."""

from dataclasses import dataclass, replace

from onika.model.task import LocalLine, Task


@dataclass(frozen=True, slots=True)
class OwnLines:
    """Lines that count in one configuration only; all others are those of the task's file."""

    aliases: tuple[tuple[str, str], ...] = ()
    """The variable behind a pin, by the coded name; the coded name itself: no alias."""
    local: tuple[LocalLine, ...] = ()
    """Parameters in place of those of the file, or beyond them; each name once."""
    without: tuple[str, ...] = ()
    """Parameters of the file that are not given here."""

    @classmethod
    def between(cls, filed: Task, changed: Task) -> "OwnLines":
        """What makes `changed` of a task as its file says."""
        before, after = dict(filed.aliases), dict(changed.aliases)
        aliases = tuple(
            (pin, after.get(pin, pin)) for pin in filed.kinds() if after.get(pin, pin) != before.get(pin, pin)
        )
        old, new = _by_key(filed.local), _by_key(changed.local)
        local = tuple(line for line in new.values() if old.get(line.key) != line)
        return cls(aliases, local, tuple(key for key in old if key not in new))

    def on(self, filed: Task) -> Task:
        """A task with these lines; an alias of a pin that is gone says nothing."""
        if self == NO_OWN_LINES:
            return filed
        return replace(filed, aliases=self._aliases(filed), local=self._local(filed))

    def _aliases(self, filed: Task) -> tuple[tuple[str, str], ...]:
        """In the order of the file, then of the pins: what is changed and changed back is as it was."""
        aliases = {**dict(filed.aliases), **dict(self.aliases)}
        order = dict.fromkeys((*(pin for pin, _ in filed.aliases), *filed.kinds()))
        return tuple((pin, aliases[pin]) for pin in order if aliases.get(pin, pin) != pin)

    def _local(self, filed: Task) -> tuple[LocalLine, ...]:
        """Where the file has a parameter several times, its own line stands once."""
        own = {line.key: line for line in self.local}
        lines: dict[int | str, LocalLine] = {}
        for place, line in enumerate(filed.local):
            if line.key in own:
                lines[line.key] = own[line.key]
            elif line.key not in self.without:
                lines[place] = line
        return tuple((lines | {key: line for key, line in own.items() if key not in lines}).values())


NO_OWN_LINES = OwnLines()


def _by_key(lines: tuple[LocalLine, ...]) -> dict[str, LocalLine]:
    """The parameters; of one that stands twice the last line counts."""
    return {line.key: line for line in lines}
