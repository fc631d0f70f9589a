import pytest

from onika.model.syntax import Edge, IconType, Syntax, application_name, has_word, object_name, same_type

NAMES = (
    "Application start",
    "Application end",
    "Complete job",
    "Complete application",
    "Complete NOP",
    "Joint job",
    "Joint application",
    "Joint object",
    "Lonely job",
)
SYNTAX = Syntax(tuple(IconType(name, 0, 0) for name in NAMES), (Edge(4, (0, 0, 0), ()),))


def kind(name: str) -> IconType:
    find = SYNTAX.find(name)
    assert find
    return find


def test_types_are_found_without_case_and_named_as_defined() -> None:
    assert kind("joint JOB").name == "Joint job"  # reading 37
    assert SYNTAX.find("Jointjob") is None


@pytest.mark.parametrize(
    ("name", "roles"),
    [
        ("Application start", {"is_start"}),
        ("Application end", {"is_end"}),
        ("Complete job", {"is_job", "is_action", "is_complete"}),
        ("Complete application", {"is_application", "is_action", "is_complete"}),
        ("Complete NOP", {"is_noop", "is_action", "is_complete"}),
        ("Joint job", {"is_job", "is_action", "needs_target"}),
        ("Joint application", {"is_application", "is_action", "needs_target"}),
        ("Joint object", {"is_target"}),
    ],
)
def test_the_role_of_a_type_follows_from_its_words(name: str, roles: set[str]) -> None:
    result = kind(name)  # R-D22
    all_roles = [role for role in dir(IconType) if role.startswith(("is_", "needs_"))]
    assert {role for role in all_roles if getattr(result, role)} == roles


def test_the_target_type_goes_by_the_words_of_the_action() -> None:
    assert SYNTAX.target_type_of("Joint job") == "Joint object"  # reading 32
    assert SYNTAX.target_type_of("joint application") == "Joint object"
    assert SYNTAX.target_type_of("Lonely job") is None
    assert SYNTAX.target_type_of("Complete job") is None
    assert SYNTAX.target_type_of("Joint object") is None


def test_unknown_jobs_and_applications_act_as_the_complete_ones() -> None:
    assert SYNTAX.acting("Force job") == kind("Complete job")  # R-D16
    assert SYNTAX.acting("Force Application") == kind("Complete application")
    assert SYNTAX.acting("Force object") is None
    assert SYNTAX.acting("Force") is None
    assert SYNTAX.acting("Joint job") == kind("Joint job")


def test_an_edge_is_found_by_its_number() -> None:
    assert SYNTAX.edge(4) == SYNTAX.edges[0]
    assert SYNTAX.edge(0) is None


def test_a_word_is_a_whole_word() -> None:
    assert has_word("My Object", "object")
    assert not has_word("My objection", "object")


def test_the_target_of_a_job_goes_by_its_name_else_by_the_only_edge_that_fits() -> None:
    kinds = (IconType("Fast job", 1, 5), IconType("Slow job", 1, 6), IconType("Slow object", 9, 1))  # reading 32
    two = (*kinds, IconType("Pose object", 5, 1))
    assert Syntax(kinds, ()).object_of(kinds[0]) == "Fast object"
    assert Syntax(two, ()).object_of(kinds[0]) == "Pose object"
    assert Syntax((*two, IconType("Other object", 5, 1)), ()).object_of(kinds[0]) == "Fast object"
    assert Syntax(two, ()).object_of(kinds[1]) == "Slow object"


def test_types_that_belong_together_differ_in_one_word() -> None:
    assert object_name("File name job") == object_name("File name application") == "File name object"
    assert application_name("File name object") == "File name application"
    assert same_type("joint  JOB", "Joint job")
    assert not same_type("Joint job", "Joint object")


def test_of_two_types_of_one_name_the_first_is_found() -> None:
    assert Syntax((IconType("A job", 0, 1), IconType("a JOB", 2, 3)), ()).find("A job") == IconType("A job", 0, 1)
