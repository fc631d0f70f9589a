import msgspec

from onika.desk.environment.shared.sight import sight


def test_what_the_icons_of_the_run_need_is_there_and_nothing_of_the_machine(watched):  # R-X21: icons
    tree = sight(watched.subject, watched.environment.tree)
    application = tree.applications[watched.doc]
    steps = watched.environment.tree.applications[watched.doc].steps
    assert application.steps == steps
    assert {step.picture for step in steps.values() if step.picture} <= {*tree.pictures}
    assert {step.type for step in steps.values() if step.type} <= {*tree.types}
    assert tree.review.recording.doc == watched.doc
    assert str(watched.base.path) not in msgspec.json.encode(tree).decode()
    assert (tree.files, tree.libraries, tree.documents, tree.preferences) == ({}, {}, {}, {})


def test_without_its_application_a_run_has_no_icons(cinema):  # R-X21: recorded elsewhere
    doc = cinema.open([])
    path = cinema.film(doc)
    cinema.look(path)
    subject = cinema.environment.model.review_session.subject
    tree = cinema.environment.tree
    bare = sight(subject, msgspec.structs.replace(tree, applications={}))
    assert (bare.applications, bare.review.recording.doc) == ({}, "")
