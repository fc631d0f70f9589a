import msgspec

from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import sheet_of
from onika.store.site import shipped
from onika.wire.sheet import ModuleSheet


def test_the_sheet_of_a_shipped_module_travels_whole():  # law 24
    path = shipped() / "generic" / "module" / "jtraj.py"
    sheet = sheet_of(load(path.read_text(), str(path), "jtraj"))
    assert sheet.inputs and sheet.trigger
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(sheet), type=ModuleSheet) == sheet
