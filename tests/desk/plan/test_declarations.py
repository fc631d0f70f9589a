import os

from onika.desk.plan.declarations import declared_inputs, declared_ports
from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import sheet_of
from onika.store.shipped import shipped
from onika.wire.sheet import InputSheet

SOURCE = """
from onika.module import Input, Module

class Go(Module):
    place = Input("double[3]", "m", "where", low=-1.0, high=[1, 2, 3])
    time = Input("double", unit="s", low="TMIN", default=2.0)
    word = Input(shape="string")
    odd = Input(SHAPE)
    other = 3
"""


def test_the_inputs_of_a_class_are_read_from_its_text(tmp_path):  # R-B10, R-D08
    path = tmp_path / "go.py"
    path.write_text(SOURCE)
    assert declared_inputs(path) == (
        InputSheet("place", "double[3]", "m", "where", -1.0, [1, 2, 3], None),
        InputSheet("time", "double", "s", "", "TMIN", None, 2.0),
        InputSheet("word", "string", "-", "", None, None, None),
    )
    path.write_text("class Go: pass\n")
    os.utime(path, ns=(1, 1))
    assert declared_inputs(path) == ()


def test_what_cannot_be_read_declares_nothing(tmp_path):  # R-B07
    (tmp_path / "bad.py").write_text("class (")
    assert declared_inputs(tmp_path / "bad.py") == declared_inputs(tmp_path / "none.py") == ()


def test_every_shipped_module_declares_in_its_text_what_its_class_does():  # R-B10
    for path in sorted(shipped().glob("*/module/*.py")):
        sheet = sheet_of(load(path.read_text("utf-8"), str(path), path.stem))
        assert declared_inputs(path) == sheet.inputs, path
        assert declared_ports(path) == sheet.ports, path
