from typing import get_args

import msgspec
import pytest

import typescript
from onika.wire import act, page

SOURCE = typescript.source()


@pytest.mark.parametrize("kind", [*get_args(act.AnyAct), *get_args(page.AnyMessage)], ids=lambda kind: kind.__name__)
def test_every_message_has_its_interface_with_its_tag(kind):
    assert f"export interface {kind.__name__} {{\n  t: '{kind.__name__}';\n" in SOURCE


@pytest.mark.parametrize(
    ("kind", "written"),
    [
        (int, "number"),
        (float, "number"),
        (str, "string"),
        (bool, "boolean"),
        (None, "null"),
        (tuple[int, str], "[number, string]"),
        (tuple[int, ...], "(number)[]"),
        (list[str], "(string)[]"),
        (dict[str, int], "Record<string, number>"),
        (int | None, "number | null"),
        (act.AnyAct | None, "AnyAct | null"),
    ],
)
def test_a_type_is_written_as_typescript_has_it(kind, written):
    assert typescript._type(msgspec.inspect.type_info(kind)) == written


def test_a_field_that_may_be_left_out_may_be_left_out_there_too():
    assert "  doc: string;\n  tasks?: Record<string, [number, number]>;" in SOURCE


def test_a_type_that_typescript_has_not_raises():
    with pytest.raises(TypeError):
        typescript._type(msgspec.inspect.type_info(complex))
