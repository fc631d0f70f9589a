"""A robot with a mesh in the view of the workcell: it is made once, and fetched by name (X19)."""

import re

import pytest
from playwright.sync_api import expect

from kit.worlds.file_cells import ARM
from onika.desk.plan.robot_files import create_robot
from onika.store.site import open_site

pytestmark = [pytest.mark.page, pytest.mark.slow]

CORNERS = " ".join(f"{x} {y} {z}" for x in (-0.08, 0.08) for y in (-0.08, 0.08) for z in (-0.2, 0.2))
FOOT = '<geom name="foot" type="cylinder" size="0.08 0.2" pos="0 0 0.2"/>'
MESHED = ARM.replace(FOOT, '<geom name="foot" type="mesh" mesh="block" pos="0 0 0.2"/>').replace(
    "<worldbody>", f'<asset><mesh name="block" vertex="{CORNERS}"/></asset><worldbody>', 1
)


FETCHED = "(count) => performance.getEntriesByType('resource')"
FETCHED += ".filter(({name}) => name.includes('/mesh/')).length >= count"


@pytest.fixture(scope="module")
def program(begin, tmp_path_factory):
    """With a robot of one mesh, made by one command."""
    folder = tmp_path_factory.mktemp("onika")
    (folder / "elbow.xml").write_text(MESHED)
    create_robot(folder / "elbow.xml", folder / "home" / "onika", open_site((), {}, None))
    return begin("jmove_elbowC", folder=folder)


def test_the_mesh_of_a_robot_comes_to_the_page_and_is_kept_by_it(program, page):  # R-X19
    meshes = []
    page.on("response", lambda answer: meshes.append(answer) if "/mesh/" in answer.url else None)
    program.enter(page)
    view = page.get_by_role("application", name=re.compile("^The workcell in three dimensions"))
    for count in (1, 2):
        page.get_by_role("button", name="Workcell elbow").click()
        expect(view.locator("canvas")).to_be_visible()
        page.wait_for_function(FETCHED, arg=count)
        page.get_by_role("button", name="Close the workcell").click()
    assert [answer.status for answer in meshes][:1] == [200]
    assert "immutable" in meshes[0].headers["cache-control"]
    assert len({answer.url for answer in meshes}) == 1
