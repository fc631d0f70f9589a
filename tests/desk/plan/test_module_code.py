from hashlib import sha256

from msgspec import structs

from onika.desk.plan.module_code import module_code, with_rights_here
from onika.store.remote.checkout_path import checkout_path

SOURCE = "# nothing\n"


def test_code_is_named_by_its_content_and_has_the_rights_of_its_file(tmp_path):  # R-X16
    own = module_code("pd", tmp_path / "module" / "pd.py", SOURCE)
    assert (own.digest, own.is_sandboxed) == (sha256(SOURCE.encode()).hexdigest(), False)
    others = checkout_path(tmp_path / "onika", tmp_path, "cmu.puma") / "module" / "pd.py"
    assert module_code("pd", others, SOURCE).is_sandboxed


def test_code_that_came_with_a_file_is_sandboxed_unless_the_same_stands_here(tmp_path):  # R-X16
    path = tmp_path / "pd.py"
    code = module_code("pd", path, SOURCE)
    assert with_rights_here(code).is_sandboxed  # there is no such file
    path.write_text(SOURCE)
    assert with_rights_here(code) == code
    liar = structs.replace(code, source="import os  # under the name of another\n")
    assert with_rights_here(liar).is_sandboxed


def test_code_of_a_library_of_others_stays_sandboxed_where_it_stands_here(tmp_path):  # R-X16
    path = checkout_path(tmp_path / "onika", tmp_path, "cmu.puma") / "module" / "pd.py"
    path.parent.mkdir(parents=True)
    path.write_text(SOURCE)
    assert with_rights_here(structs.replace(module_code("pd", path, SOURCE), is_sandboxed=False)).is_sandboxed
