import pytest

from kit.study.log_text import assembly
from onika.study import folder


@pytest.fixture
def study(tmp_path):
    """Two groups of three; w3 has a log that is cut, x1 is alone in its group."""
    seconds = {"b1": 4.0, "b2": 5.0, "b3": 4.5, "w1": 8.0, "w2": 9.0, "w3": 8.6, "x1": 6.0}
    for name, selection_s in seconds.items():
        text = assembly(selection_s)
        (tmp_path / f"{name}.log").write_text(text[:-6] if name == "w3" else text)
    rows = [f"{name},{name[0].replace('x', '<x>')}" for name in seconds]
    (tmp_path / "subjects.csv").write_text("subject,group\n" + "\n".join(rows) + "\n")
    answers = ",".join(f"sus{number}" for number in range(1, 11))
    (tmp_path / "questionnaires.csv").write_text(f"subject,{answers}\nb1,5,1,5,1,5,1,5,1,5,1\nw1{',3' * 10}\n")
    return folder.read(tmp_path)
