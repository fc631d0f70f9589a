"""The papers of a study: whole, the same in both languages, and never written over."""

import csv
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from onika.study import folder
from onika.study.kit import create, files, papers


def shape(text):
    """The tags of a page in their order."""
    body = text[text.index("<body>") : text.index("</body>") + 7]
    return [(element.tag, element.get("class")) for element in ET.fromstring(body).iter()]


def test_every_paper_is_there_in_both_languages_with_the_same_parts():  # R-H05
    english, spanish = papers("en"), papers("es")
    assert [*english] == [*spanish]
    assert [name[2:-5] for name in english] == [
        "consent", "demographics", "checklist", "script", "warm-up", "task", "help-sheet", "usability", "workload",
    ]  # fmt: skip
    for name, text in english.items():
        assert shape(text) == shape(spanish[name]), name
        assert text != spanish[name]


def test_the_papers_are_for_printing_and_need_nothing_else():  # R-H05
    for text in (*papers("en").values(), *papers("es").values()):
        assert "@media print" in text
        assert not re.search(r"(src|href)=", text)


def test_the_papers_have_what_the_procedure_of_the_source_asks_for():  # R-H05
    english = papers("en")
    assert english["3-checklist.html"].count("<tr><td>") == 3 + 4
    assert "three attempts" in english["5-warm-up.html"]
    assert "one hour" in english["6-task.html"]
    assert english["8-usability.html"].count("○") == 10 * 5
    assert english["9-workload.html"].count("<td>|</td>") == 6 * 21


LABELS = Path(__file__).parents[2] / "browser" / "src" / "texts"
NAMED = {
    "3-checklist": ("upper.first.new", "perform.putBack"),
    "4-script": ("upper.first.new", "newApplication.one", "newApplication.create", "perform.putBack"),
    "6-task": ("upper.first.new",),
    "7-help-sheet": ("upper.first.new", "newApplication.one", "newApplication.create", "stop.name"),
}


@pytest.mark.parametrize("language", ["en", "es"])
def test_the_papers_call_what_is_in_the_page_by_its_labels(language):  # R-H05
    source = "".join(path.read_text() for path in LABELS.glob(f"{language}.*.ts"))
    labels = dict(re.findall(r"'([\w.]+)':\s+'([^'\n]*)'", source))
    for name, keys in NAMED.items():
        text = re.sub(r"<[^>]*>", "", papers(language)[f"{name}.html"])
        assert [labels[key] for key in keys if labels[key] not in text] == [], name


def test_a_kit_is_made_once_and_is_the_folder_of_a_study(tmp_path):  # R-H05
    paths = create(tmp_path / "folk")
    assert len(paths) == len(files()) == 19
    header = next(csv.reader([(tmp_path / "folk" / "questionnaires.csv").read_text()]))
    assert header[:2] == ["subject", "sus1"]
    study = folder.read(tmp_path / "folk")
    assert (study.subjects, study.faults) == ((), ())
    with pytest.raises(FileExistsError):
        create(tmp_path / "folk")
