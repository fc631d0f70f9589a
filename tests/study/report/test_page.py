import re
import xml.etree.ElementTree as ET

from onika.study.compared import compared
from onika.study.folder import Study
from onika.study.report.page import page
from onika.words.reason import in_language


def in_spanish(reason):
    return in_language(reason, "es")


def test_the_page_says_what_is_wrong_compares_and_shows_every_subject(study):  # R-H02, R-H03
    text = page(study, compared(study.subjects), str, "en")
    assert "w3.log:30: expected 7 columns, parted by tabs, found 6; instead: the line is left out" in text
    assert "&lt;x&gt; has one subject" in text
    assert "<x>" not in text
    assert text.count(">analysis of variance</th>") == 2  # deletions and attempts are all equal
    assert "All values are equal" in text
    assert len(re.findall(r'id="subject-', text)) == 7
    assert "SUS" in text
    for picture in re.findall(r"<svg.*?</svg>", text, re.DOTALL):
        ET.fromstring(picture)


def test_the_page_loads_nothing(study):  # R-H02
    text = page(study, compared(study.subjects), str, "en")
    assert "default-src 'none'" in text
    assert not re.search(r"(src|href)=", text)
    assert "<script" not in text


def test_the_page_speaks_spanish(study):  # R-H02
    text = page(study, compared(study.subjects), in_spanish, "es")
    assert '<html lang="es">' in text
    assert "Los grupos comparados" in text
    assert "analysis of variance" not in text


def test_a_study_of_nobody_is_a_page_too():  # R-H02
    assert "nothing that could be compared" in page(Study("empty", ()), (), str, "en")
