from dataclasses import replace
from hashlib import sha256

import msgspec
import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.refresh import refreshed
from onika.files import rmod
from onika.files.rmod import RmodText
from onika.model.task import LocalLine, Task
from onika.wire import act, event, live
from onika.words.reason import Reason

A = Task("a", "a", outvar=("A",), frequency=10.0, local=(LocalLine("GAIN", ("1",)),))
B = Task("b", "b", outvar=("B",), frequency=10.0)


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, (A, B), LiveRuntime())


def written(duet, path, text):
    path.write_text(text)
    duet.says.clear()
    duet.environment.become(lambda model: refreshed(model, {path}))
    duet.pump()


def rewritten(duet, task):
    written(duet, duet.base.task_file(task.name), rmod.write(RmodText(task)))


def described(duet, module):
    """As when a runtime has read the code that the file has now."""
    digest = sha256(duet.base.code_file(module).read_bytes()).hexdigest()

    def change(model):
        libraries = replace(model.libraries, digests={**model.libraries.digests, module: digest})
        return Done(replace(model, libraries=libraries))

    duet.environment.become(change)


def behind(duet, doc):
    problems = duet.environment.tree.documents[doc].problems
    return {key: problem for key, problem in problems.items() if key.startswith("stale")}


def test_a_task_that_is_on_while_another_program_writes_its_code_is_asked_about_at_once(duet):  # law 21
    doc = duet.connected("a", "b")
    duet.do(act.Toggle(doc, "a"))
    written(duet, duet.base.code_file("a"), "# other code\n")
    assert [(say.text.key, say.doc) for say in duet.says] == [("run.lives_with_older_code", doc)]
    described(duet, "a")
    (problem,) = behind(duet, doc).values()
    assert problem.level == "warning" and problem.remedies[0].act == act.Renew(doc, "a")
    duet.do(problem.remedies[0].act)
    assert [message.task for message in duet.carried_out if isinstance(message, live.Swap)] == ["a"]
    assert behind(duet, doc) == {}


def test_a_task_whose_code_is_the_runtimes_own_is_behind_no_file(duet):  # R-A19
    doc = duet.connected("a")

    def own(model):
        document = model.documents[doc]
        facts = document.live.tasks["a"]
        facts = replace(facts, planned=msgspec.structs.replace(facts.planned, digest=""))
        living = replace(document.live, tasks={**document.live.tasks, "a": facts})
        return Done(replace(model, documents={**model.documents, doc: replace(document, live=living)}))

    duet.environment.become(own)
    written(duet, duet.base.code_file("a"), "# other code\n")
    described(duet, "a")
    assert (behind(duet, doc), duet.says) == ({}, [])


def test_a_file_that_says_other_things_of_a_living_task_is_taken_over_by_one_button(duet):  # law 21, R-C04
    doc = duet.connected("a")
    duet.do(act.Toggle(doc, "a"))
    rewritten(duet, replace(A, local=(LocalLine("GAIN", ("2",)),)))
    assert [say.text.key for say in duet.says] == ["run.lives_as_filed_before"]
    (problem,) = behind(duet, doc).values()
    duet.do(problem.remedies[0].act)
    change = duet.edits()[-1]
    assert (change.kill, [task.local for task in change.spawn]) == (("a",), [(("GAIN", ("2",)),)])
    assert behind(duet, doc) == {} and duet.state(doc, "a") == "ON"


def test_what_a_configuration_says_itself_of_a_task_is_not_behind(duet):  # R-B09
    doc = duet.connected("a")
    duet.do(act.Local("a", (("GAIN", ("5",)),), doc))
    assert duet.edits()[-1].spawn[0].local == (("GAIN", ("5",)),)
    assert behind(duet, doc) == {}


def test_a_description_alone_concerns_no_living_task(duet):
    doc = duet.connected("a")
    rewritten(duet, replace(A, description="new"))
    assert (behind(duet, doc), duet.says) == ({}, [])


def test_nothing_is_behind_where_nothing_lives(duet):
    doc = duet.new("a")
    rewritten(duet, replace(A, local=()))
    assert behind(duet, doc) == {}


def test_whoever_drives_a_world_whose_files_were_changed_is_offered_a_runtime_that_loads_it_anew(tmp_path):  # law 21
    arm = replace(A, local=(LocalLine("DEVICE", ("cell:arm",)),))
    duet = FakeRuntimeEnv(tmp_path, (arm, B), LiveRuntime())
    doc, other = duet.connected("a"), duet.connected("b")
    for world in ("cell", "yard"):
        duet.tell(event.Outdated(world, True, Reason.plain(f"{world} was changed"), 1.0))
    assert behind(duet, other) == {}
    (problem,) = behind(duet, doc).values()
    assert (str(problem.text), problem.remedies[0].act) == ("cell was changed", act.StartAnew())
    duet.environment.become(
        lambda model: Done(replace(model, runtime=msgspec.structs.replace(model.runtime, address="x")))
    )
    assert [problem.remedies for problem in behind(duet, doc).values()] == [()]  # it is not ours to end
    duet.tell(event.Outdated("cell", False, Reason.plain("as it was"), 2.0))
    assert behind(duet, doc) == {}


def test_who_shows_a_file_is_told_that_it_was_written(duet):  # R-C05
    path = str(duet.base.code_file("a"))
    written(duet, duet.base.code_file("a"), "# one\n")
    first = duet.environment.tree.touched[path]
    written(duet, duet.base.code_file("a"), "# two\n")
    assert duet.environment.tree.touched[path] > first
    duet.environment.become(lambda model: refreshed(model, {duet.base.task_file("a")}))
    assert list(duet.environment.tree.touched) == [path]  # it says what it said
