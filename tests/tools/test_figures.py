"""The counter of what makes code hard to read counts what it says, and fails above its limits."""

import ast

import pytest

import figures

ROOMY = dict.fromkeys(
    (
        "vague-names",
        "conditionals",
        "complex-functions",
        "complexity",
        "folder",
        "sentences",
        "mutual-imports",
        "ambiguous-names",
    ),
    1000,
)


@pytest.fixture
def house(tmp_path):
    """Writes a small repository of the given files, with roomy limits but for those named."""

    def write(files, **limits):
        rows = [f"{name} = {limit}" for name, limit in {**ROOMY, **limits}.items()]
        project = "\n".join(["[tool.onika.figures]", *rows])
        for name, text in {"pyproject.toml": project, "src/onika/__init__.py": "", **files}.items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text)
        return tmp_path

    return write


def figure(root, name):
    return next(row for row in figures.count(root).rows() if row[0] == name)


def test_vague_names_are_counted_among_names_and_parameters(house):
    root = house({"src/onika/a.py": "def f(found, task):\n    return found\n"})
    assert figure(root, "vague-names")[2] == pytest.approx(66.67)


def test_conditional_expressions_are_counted_by_lines(house):
    root = house({"src/onika/a.py": "a = 1 if b else 2\n" + "c = 3\n" * 99})
    assert figure(root, "conditionals")[2] == 10


def test_complexity_counts_branches_and_each_further_operand():
    function = ast.parse("def f(a, b, c):\n    if a and b and c:\n        return [x for x in a if x]\n").body[0]
    assert figures.complexity(function) == 5


def test_a_complex_function_is_named_with_its_line(house):
    branches = "".join(f"    if a == {number}:\n        return {number}\n" for number in range(14))
    root = house({"src/onika/a.py": f"def f(a):\n{branches}"})
    assert figure(root, "complex-functions")[2:] == (1, ["15 src/onika/a.py:1 f"])


def test_folders_of_the_page_count_too(house):
    root = house({f"browser/src/canvas/{number}.ts": "" for number in range(3)})
    assert figure(root, "folder")[2:] == (3, ["3 browser/src/canvas", "1 src/onika"])


def test_folders_of_tests_count_too(house):
    root = house({f"tests/kit/{number}.py": "" for number in range(4)})
    assert figure(root, "folder")[2:] == (4, ["4 tests/kit", "1 src/onika"])


@pytest.mark.parametrize(
    "line",
    [
        'rows = [(r"(.+) does not fit behind (.+)", 1)]',
        'text.removeprefix("no recording can be made")',
        'text.partition(", found nothing")',
    ],
)
def test_a_sentence_that_is_taken_apart_is_found(house, line):
    assert figure(house({"src/onika/a.py": line + "\n"}), "sentences")[2] == 1


@pytest.mark.parametrize("line", ['re.compile(r"[a-z]+ *= *(.+)")', '"no recording can be made"', 'text.split("; ")'])
def test_a_grammar_and_a_plain_sentence_are_none(house, line):
    assert figure(house({"src/onika/a.py": line + "\n"}), "sentences")[2] == 0


def test_a_sentence_that_is_taken_apart_in_the_page_is_found(house):
    lines = ["const row = [/^(.+) does not fit/, 1]", "const half = a / b", "const named = /(?<left>.+) goes on/"]
    root = house({"browser/src/a.ts": "\n".join(lines)})
    assert figure(root, "sentences")[3] == [
        "browser/src/a.ts:1 ^(.+) does not fit",
        "browser/src/a.ts:3 (?<left>.+) goes on",
    ]


def test_packages_that_import_each_other_are_a_pair_at_any_depth(house):
    root = house(
        {
            "src/onika/desk/__init__.py": "",
            "src/onika/desk/plan/__init__.py": "",
            "src/onika/desk/plan/a.py": "from onika.desk.run.review.b import c\n",
            "src/onika/desk/run/review/b.py": "",
            "src/onika/desk/run/d.py": "def e():\n    from onika.desk.plan import a\n",
        }
    )
    assert figure(root, "mutual-imports")[3] == ["onika/desk/plan and onika/desk/run"]


def test_a_package_and_one_within_it_may_import_one_way_only(house):
    one_way = {"src/onika/desk/a.py": "from onika.desk.plan import b\n", "src/onika/desk/plan/b.py": ""}
    assert figure(house(one_way), "mutual-imports")[2] == 0
    back = {"src/onika/desk/plan/b.py": "import onika.desk.a\n"}
    assert figure(house(back), "mutual-imports")[3] == ["onika/desk and onika/desk/plan"]


def test_above_a_limit_the_check_fails_and_names_the_place(house, capsys):
    root = house({"src/onika/a.py": "found = 1\n"}, **{"vague-names": 1})
    assert figures.main(["--check", "--root", str(root)]) == 1
    shown = capsys.readouterr().out
    assert "100  vague names in 100 identifiers (limit 1, ABOVE IT)" in shown
    assert "1 src/onika/a.py" in shown


def test_within_the_limits_the_check_says_nothing(house, capsys):
    assert figures.main(["--check", "--root", str(house({"src/onika/a.py": "task = 1\n"}))]) == 0
    assert capsys.readouterr().out == ""


def test_tags_and_comments_of_the_page_are_no_regular_expressions(house):
    lines = ['<b>{name}</b><i class="small note">{note}</i>', " /** As in `/`, `Delete`; the first is shown. */"]
    assert figure(house({"browser/src/A.svelte": "\n".join(lines)}), "sentences")[2] == 0
