import pytest

from onika.desk.sweep.case import Case, CaseResult
from onika.desk.sweep.results_file import ResultsFile, SweepHead, open_results
from onika.words.fault import Fault
from onika.words.reason import Reason

HEAD = SweepHead(1, ("stack",), "abc")
RESULTS = [
    CaseResult(Case(0, {"pd.STIFF": 0.1}), "completed", lasted_s=2.5, hash="f00"),
    CaseResult(Case(7), "aborted", Reason.of("sweep.unmet", expectation="LAMP == 1")),
]


@pytest.fixture
def path(tmp_path):
    path = tmp_path / "stack.sweep"
    file = open_results(path, HEAD)
    for result in RESULTS:
        file.add(result)
    file.close()
    return path


def known(path, head=HEAD):
    file = open_results(path, head)
    assert isinstance(file, ResultsFile), file
    file.close()
    return file.results


def test_what_was_kept_is_known_when_it_is_opened_again(path):  # R-X23
    assert known(path) == {0: RESULTS[0], 7: RESULTS[1]}


def test_a_last_line_that_was_cut_is_done_again_and_all_others_stay(path):  # R-X23
    content = path.read_bytes()
    for cut in range(1, len(content.splitlines()[-1]) + 1):
        path.write_bytes(content[:-cut])
        assert known(path) == {0: RESULTS[0]}
        file = open_results(path, HEAD)
        file.add(RESULTS[1])
        file.close()
        assert path.read_bytes() == content


@pytest.mark.parametrize(
    ("head", "words"),
    [
        (
            SweepHead(1, ("stack", "--no-shake"), "abc"),
            "expected the results of `stack --no-shake`, found those of `stack`",
        ),
        (SweepHead(1, ("stack",), "abd"), "is no more what it was"),
    ],
)
def test_the_results_of_another_sweep_are_not_mixed_with_these(path, head, words):  # R-X23
    before = path.read_bytes()
    fault = open_results(path, head)
    assert isinstance(fault, Fault)
    assert words in str(fault.reason)
    assert path.read_bytes() == before


@pytest.mark.parametrize("content", [b"\xff\xfe\n", b"{}\n", b'{"sweep":1,"command":[],"plan":""}\nno line\n', b"[]\n"])
def test_what_are_no_results_is_told_and_stays_as_it_is(tmp_path, content):  # R-X23, R-B07
    path = tmp_path / "photo.sweep"
    path.write_bytes(content)
    assert isinstance(open_results(path, SweepHead(1, (), "")), Fault)
    assert path.read_bytes() == content


def test_a_place_where_nothing_can_be_written_is_told(tmp_path):  # R-B07
    assert isinstance(open_results(tmp_path / "no" / "stack.sweep", HEAD), Fault)
    assert isinstance(open_results(tmp_path, HEAD), Fault)


def test_each_result_is_in_the_file_as_soon_as_it_is_there(tmp_path):  # R-X23
    path = tmp_path / "stack.sweep"
    file = open_results(path, HEAD)
    before = path.stat().st_size
    file.add(RESULTS[0])
    assert path.stat().st_size > before
    file.close()
