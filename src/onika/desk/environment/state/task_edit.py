"""What a user changes of a task without its file: aliases and parameters (requirement C04)."""

from dataclasses import replace

from onika.model.task import LocalLine, Task


def aliased(task: Task, pin: str, svar: str, filed: Task) -> Task:
    """With another variable behind a pin; none, or the coded name, takes the alias away.

    Aliases stand in the order of the file, then of the pins: what is changed and changed back is as it was.
    """
    aliases = {**dict(task.aliases), pin: svar}
    if svar in ("", pin):
        del aliases[pin]
    return _with_aliases(task, aliases, filed)


def carried(changed: Task, filed: Task) -> Task:
    """What was changed, on the file as it is now; an alias of a pin that is gone is gone."""
    pins = filed.kinds()
    aliases = {pin: svar for pin, svar in changed.aliases if pin in pins}
    return _with_aliases(replace(filed, local=changed.local), aliases, filed)


def rebased(changed: Task, former: Task, filed: Task) -> Task:
    """What was changed of a file as it was, on the file as it is now: what nobody changed here is as the file says."""
    old, new, wished = dict(former.aliases), dict(filed.aliases), dict(changed.aliases)
    aliases = dict(new)
    for pin in filed.kinds():
        if wished.get(pin) == old.get(pin):
            continue
        if pin in wished:
            aliases[pin] = wished[pin]
        else:
            aliases.pop(pin, None)
    local: tuple[LocalLine, ...] = filed.local if changed.local == former.local else changed.local
    return _with_aliases(replace(filed, local=local), aliases, filed)


def _with_aliases(task: Task, aliases: dict[str, str], filed: Task) -> Task:
    order = dict.fromkeys((*(pin for pin, _ in filed.aliases), *task.kinds()))
    return replace(task, aliases=tuple((pin, aliases[pin]) for pin in order if pin in aliases))
