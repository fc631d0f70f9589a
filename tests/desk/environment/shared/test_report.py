import json
import zipfile

from onika.desk.environment.shared.report import report_parts, write_report
from onika.record.reader import Reader


def test_a_report_holds_what_an_issue_needs(watched):  # R-X21: bundles why it stopped
    parts = {part.name: part for part in report_parts(watched.subject, watched.site)}
    application = watched.subject.view.name
    assert parts.keys() >= {"why.txt", "machine.txt", "libraries.txt", "recording.mcap"}
    assert application in parts["why.txt"].content.decode()
    assert "onika" in parts["machine.txt"].content.decode()
    digests = [code.digest for code in watched.subject.review.run.prepare.plan.code]
    assert all(digest in parts["libraries.txt"].content.decode() for digest in digests)
    assert all(str(part.about) for part in parts.values())


def test_nothing_of_it_names_the_home(watched, tmp_path):  # R-X21: nothing secret
    home = str(watched.base.path)
    parts = report_parts(watched.subject, watched.site, home)
    assert home in json.dumps([code.path for code in watched.subject.review.run.prepare.plan.code])
    for part in parts:
        if part.name != "recording.mcap":
            assert home.encode() not in part.content, part.name
    (tmp_path / "copy.mcap").write_bytes(parts[-1].content)
    reader = Reader(tmp_path / "copy.mcap")
    for name in ("plan.json", "begin.json", "code.json"):
        assert home.encode() not in reader.attachment(name)


def test_a_report_is_one_file(watched, tmp_path):  # R-X21
    parts = report_parts(watched.subject, watched.site)
    write_report(tmp_path / "report.zip", parts)
    with zipfile.ZipFile(tmp_path / "report.zip") as bundle:
        assert bundle.namelist() == [part.name for part in parts]
        assert bundle.read("why.txt") == parts[0].content
