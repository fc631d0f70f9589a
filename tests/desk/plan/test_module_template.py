import pytest
from hypothesis import given, strategies as st

from onika.desk.plan.module_template import create_module
from onika.files import rmod
from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import differences, sheet_of
from onika.words.fault import Place


@pytest.mark.parametrize(("name", "title"), [("gain", "Gain"), ("low_pass", "LowPass"), ("pass2", "Pass2")])
def test_a_module_its_rmod_and_its_test_agree(tmp_path, name, title):  # R-K05
    code, task, test = create_module(name, tmp_path)
    cls = load(code.read_text(), str(code), name)
    assert cls.__name__ == title
    record, faults = rmod.read(task.read_text(), name, str(task))
    assert faults == ()
    assert record.task.module == name
    assert differences(record.task, sheet_of(cls), Place(str(task))) == []
    assert test.name == f"test_{name.replace('-', '_').replace('.', '_')}.py"
    assert compile(test.read_text(), str(test), "exec")


@pytest.mark.parametrize("name", ["", "9lives", "a b", "../up", "a/b", "é", "a\n", "-x", "class!"])
def test_what_is_no_name_is_refused_and_nothing_is_written(tmp_path, name):  # R-B08
    with pytest.raises(ValueError, match="expected a name"):
        create_module(name, tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_nothing_is_ever_written_over(tmp_path):  # R-B08
    for folder, file in (("module", "gain.py"), ("module", "gain.rmod"), ("tests", "test_gain.py")):
        (tmp_path / folder).mkdir(exist_ok=True)
        path = tmp_path / folder / file
        path.write_text("mine")
        with pytest.raises(ValueError, match="is there already: nothing was written"):
            create_module("gain", tmp_path)
        assert [path for path in tmp_path.rglob("*") if path.is_file()] == [path]
        path.unlink()


@given(st.text(max_size=12))
def test_whatever_the_name_nothing_is_written_outside_the_base_directory(tmp_path_factory, name):  # R-B08
    base = tmp_path_factory.mktemp("base") / "inner"
    try:
        paths = create_module(name, base)
    except ValueError:
        assert not base.exists()
    else:
        assert all(base in path.resolve().parents for path in paths)
        assert list(base.parent.iterdir()) == [base]


def test_a_place_that_cannot_be_written_is_told(tmp_path):  # R-B07
    (tmp_path / "module").mkdir()
    (tmp_path / "module" / "gain.py").symlink_to("gain.py")
    with pytest.raises(ValueError, match="cannot be saved"):
        create_module("gain", tmp_path)
