"""An act: one thing that a user does, and the words that acts share."""

from msgspec import Struct

Names = tuple[str, ...]
Point = tuple[int, int]


class Act(Struct, frozen=True, forbid_unknown_fields=True, tag_field="t", tag=True, omit_defaults=True):
    """One thing that a user does."""
