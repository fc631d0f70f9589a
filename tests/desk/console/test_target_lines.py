from onika.files import onk
from onika.store.site import open_site

MOVE = """from onika.module import InVar, Input, Module

class Move(Module):
    Q_MEZ = InVar("double[NDOF]", "rad")
    PACE = InVar("double[NDOF]", "rad/s")
    endpoint = Input("double[NDOF]", "rad")
    duration = Input("double", "s")
"""
RMOD = """MODULE      move
DESC        Moves.
INCONST     none
OUTCONST    none
INVAR       Q_MEZ PACE
OUTVAR      none
TASKTYPE    periodic
FREQ        100

ONIKA
OBJECT      Joint job

EOF
"""
NOW = {"Q_MEZ": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], "PACE": [1.0] * 6, "TABLE": [[1.0, 2.0], [3.0, 4.0]], "T": 2.5}


def sitting(sit, home):
    (home / "module").mkdir()
    (home / "module" / "move.py").write_text(MOVE)
    (home / "module" / "move.rmod").write_text(RMOD)
    sitting = sit()
    sitting.does("spawn puma")
    sitting.runtime.variables = {"main": NOW}
    return sitting


def target(path):
    syntax, _ = open_site([], {}, None).syntax()
    onikon, faults = onk.read(path.read_text(), path.stem, str(path), syntax)
    assert not faults
    return onikon


def test_a_target_is_made_of_what_a_variable_holds_now(sit, tmp_path):  # R-C30, R-D08
    site = sitting(sit, tmp_path)
    (line,) = site.does("target shelf Q_MEZ joint duration=2")
    path = tmp_path / "onika" / "dict" / "shelf.onk"
    assert line == f"shelf is a Joint target now, in {path}"
    assert (target(path).type, target(path).values) == ("Joint object", ((0.1, 0.2, 0.3, 0.4, 0.5, 0.6), (2.0,)))


def test_the_type_may_be_left_out_where_one_alone_takes_it(sit, tmp_path):  # R-C30
    site = sitting(sit, tmp_path)
    site.does(f"target shelf Q_MEZ duration=2 in {tmp_path}")
    assert target(tmp_path / "dict" / "shelf.onk").type == "Joint object"
    assert "several types of target take T" in str(site.fails("target wait T").reason)


def test_what_does_not_fit_is_refused_in_words_and_nothing_is_written(sit, tmp_path):  # R-C30, R-X01
    site = sitting(sit, tmp_path)
    reasons = {
        line: str(site.fails(f"target {line}").reason)
        for line in (
            "fast PACE joint duration=2",
            "all TABLE",
            "shelf Q_MEZ joint",
            "shelf Q_MEZ joint duration=soon",
            "shelf Q_MEZ joint duration=2 colour=3",
            "shelf Q_MEZ sideways",
            "shelf Q_NONE joint",
            "9.9/ Q_MEZ joint duration=2",
        )
    }
    assert reasons["fast PACE joint duration=2"].endswith("Joint target: endpoint is in rad, this in rad/s")
    assert reasons["all TABLE"].startswith("TABLE is double[2,2], which no type of target takes: ")
    assert reasons["shelf Q_MEZ joint"].endswith("also needs duration: say `duration=…`")
    assert "'soon'" in reasons["shelf Q_MEZ joint duration=soon"]
    assert reasons["shelf Q_MEZ joint duration=2 colour=3"].endswith("has no colour")
    assert reasons["shelf Q_MEZ sideways"].startswith("'sideways' is no type of target; there are ")
    assert "Q_NONE" in reasons["shelf Q_NONE joint"]
    assert "9.9/" in reasons["9.9/ Q_MEZ joint duration=2"]
    assert not (tmp_path / "onika").exists()


def test_a_name_stands_for_one_icon(sit, tmp_path):  # R-D15
    site = sitting(sit, tmp_path)
    site.does("target shelf Q_MEZ joint duration=2")
    before = (tmp_path / "onika" / "dict" / "shelf.onk").read_text()
    assert "shelf.onk" in str(site.fails("target shelf Q_MEZ joint duration=3").reason)
    assert (tmp_path / "onika" / "dict" / "shelf.onk").read_text() == before
