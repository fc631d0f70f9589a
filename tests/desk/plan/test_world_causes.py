"""What follows from a world or a model that was left out stands behind what is wrong with its file."""

from kit.labs.laboratory import Laboratory
from onika.desk.plan.world_causes import with_causes
from onika.store.site import open_site
from onika.words.cause import by_cause
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

LEFT_OUT = Reason.of("files.world_left_out")


def site_with(tmp_path):
    laboratory = Laboratory(tmp_path / "lab")
    for folder, name in (("world", "yard.world"), ("robot", "crane.robot")):
        (laboratory.path / folder).mkdir(parents=True, exist_ok=True)
        (laboratory.path / folder / name).write_text("VERSION 2.0\nEOF\n")
    return open_site((laboratory.path,), {}, None), laboratory.path


def of_device(key, **args):
    return Fault(Place("/lab/module/crane.rmod"), Reason.of(key, device="yard:crane_bay", **args), LEFT_OUT)


def test_a_device_is_lacking_for_what_is_wrong_with_the_text_of_its_world(tmp_path):  # R-B07, R-X19
    site, lab = site_with(tmp_path)
    cause = Fault(Place(str(lab / "world" / "yard.world"), 3), Reason.plain("FLOOR bad"), LEFT_OUT)
    for lacking in (
        of_device("host.no_world_of_device", worlds=()),
        of_device("host.no_such_device", world="yard", devices=()),
    ):
        (group,) = by_cause(with_causes([lacking, cause], site))
        assert (group.fault, group.consequences) == (cause, (lacking,))
        assert with_causes([lacking], site)[0].because == ()


def test_a_model_is_lacking_for_what_is_wrong_with_its_file(tmp_path):  # R-B07, R-X19
    site, lab = site_with(tmp_path)
    cause = Fault(Place(str(lab / "robot" / "crane" / "crane.xml"), 12), Reason.plain("not well-formed"), LEFT_OUT)
    lacking = Reason.of("workcell.model_missing", name="robot/crane/crane.xml")
    missing = Fault(Place(str(lab / "robot" / "crane.robot"), 4), lacking, LEFT_OUT)
    (group,) = by_cause(with_causes([missing, cause], site))
    assert (group.fault, group.consequences) == (cause, (missing,))


def test_other_faults_are_as_they_were(tmp_path):  # R-B07
    site, lab = site_with(tmp_path)
    other = Fault(Place(str(lab / "world" / "yard.world"), 3), Reason.plain("FLOOR bad"), LEFT_OUT)
    (same,) = with_causes([other], site)
    assert same is other
