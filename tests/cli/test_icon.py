from onika.cli import main
from onika.files.rmod import RmodText
from onika.model.configuration import Configuration, Placed
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory


def test_an_icon_is_made_and_its_file_and_type_are_told(tmp_path, capsys):  # R-D09
    base = BaseDirectory(tmp_path)
    base.save_task(RmodText(Task("jmove", "jtraj", frequency=1.0, object_type="Joint job")))
    base.save_configuration(Configuration("again", (Placed("jmove"),)))
    path = str(base.configuration_file("again"))
    assert main(["icon", path, "--desc", "moves once more"]) == 0
    assert capsys.readouterr().out == f"{base.onikon_file('again')}: Joint job\n"
    assert "DESC        moves once more\n" in base.onikon_file("again").read_text()


def test_why_there_is_none_is_told(tmp_path, capsys):
    assert main(["icon", str(tmp_path / "x.conf")]) == 1
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "x.conf: expected a file NAME.conf or NAME.appl, found none" in captured.err


def test_the_icon_of_something_else_is_replaced_only_when_it_is_said(tmp_path, capsys):  # reading 34
    base = BaseDirectory(tmp_path)
    base.save_task(RmodText(Task("servo", "pd", frequency=1.0)))
    base.save_configuration(Configuration("x", (Placed("servo"),)))
    base.onikon_file("x").parent.mkdir()
    base.onikon_file("x").write_text("WRONG\n")
    path = str(base.configuration_file("x"))
    assert main(["icon", path]) == 1
    assert capsys.readouterr().err
    assert main(["icon", path, "--replace", "--local", str(tmp_path)]) == 0
