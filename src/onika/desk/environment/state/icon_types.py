"""The types of icons as a page shows them: their roles, edges and data (requirements D02, D22)."""

from onika.desk.environment.state.model import Model
from onika.desk.environment.state.target_items import items_of
from onika.model.syntax import IconType, Syntax
from onika.wire.view import Role, TypeView


def role_of(kind: IconType | None) -> Role:
    """What icons of a type stand for, by the words of its name."""
    if kind is None:
        return ""
    roles: tuple[tuple[Role, bool], ...] = (
        ("start", kind.is_start),
        ("end", kind.is_end),
        ("nop", kind.is_noop),
        ("target", kind.is_target),
        ("job", kind.is_job),
        ("application", kind.is_application),
    )
    return next((role for role, is_so in roles if is_so), "")


def edges_of(kind: IconType | None) -> tuple[str, str]:
    """The keys of its left and right edge in `view.Tree.edges`."""
    if kind:
        return (str(kind.left_edge), str(kind.right_edge))
    return ("", "")


def type_views(model: Model) -> dict[str, TypeView]:
    """Every type of the syntax definition, by its name."""
    syntax = model.syntax
    if syntax is None:
        return {}
    return {kind.name: _view(kind, order, syntax, model) for order, kind in enumerate(syntax.types)}


def _view(kind: IconType, order: int, syntax: Syntax, model: Model) -> TypeView:
    left, right = edges_of(kind)
    takes = syntax.object_of(kind) if kind.needs_target else ""
    return TypeView(order, role_of(kind), left, right, items_of(model, kind.name), takes)
