"""An onikon: the picture of a job, target or application with its type and values (dissertation §5.4, §A.3)."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from onika.model.picture import Picture
from onika.model.syntax import DataItem, Syntax
from onika.words import argument
from onika.words.reason import Reason
from onika.words.value import Value


def fits(values: Sequence[Sequence[Value]], items: Sequence[DataItem]) -> bool:
    """Whether there are as many values of each data item as there can be."""
    return len(values) == len(items) and all(item.takes(len(some)) for item, some in zip(items, values, strict=True))


@dataclass(frozen=True, slots=True)
class Onikon:
    """What an `.onk` file says; `values` holds one tuple per data item of its type, none for actions."""

    name: str
    type: str
    description: str
    values: tuple[tuple[Value, ...], ...]
    picture: Picture
    more_targets: tuple[str, ...] = ()
    """Of an action: the types of the targets that follow the one its own type names (requirement D13)."""
    words: tuple[tuple[str, str], ...] = ()
    """Its description in other languages, each with the code of its language before it (requirement X11)."""
    arm: str = ""
    """Of a target: the task of the arm whose joints its values are; empty: any arm's, or nobody knows (D08)."""

    def as_placed(self) -> "Onikon":
        """This icon as it is placed in an application: other languages and its arm stay in the dictionary."""
        return replace(self, words=(), arm="") if self.words or self.arm else self

    def argument_line(self, syntax: Syntax) -> str:
        """The values in the order of the definition, as the argument line of a task (reading 40).

        Raises ValueError where the type is unknown or the values are not those of its data items.
        """
        kind = syntax.find(self.type)
        items = kind.items if kind else ()
        if kind is None or not fits(self.values, items):
            expected = tuple(f"{item.count} {item.type.value}" for item in items) or Reason.of("rules.no_values")
            given = repr(self.values)
            raise ValueError(
                Reason.of("rules.values_of_type", items=expected, name=self.name, type=self.type, given=given)
            )
        return argument.join(
            item.type.show(value) for item, values in zip(items, self.values, strict=True) for value in values
        )
