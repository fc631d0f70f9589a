"""Opening the view of a world with 20 MB of meshes in the page: the first time, again, and in another browser.

Usage: python tools/bench/meshes.py [--links N]. The robot has a mesh of 40,000 triangles (2 MB as STL) on each of its
links. The time is that from the click on the world's name until the last mesh has come, in a real Chromium; the picture
is drawn by software where there is no GPU.
"""

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np
from browse.chromium import FLAGS, path
from browse.program import program, said
from playwright.sync_api import Browser, Page, sync_playwright

from onika.desk.plan.robot_files import create_robot
from onika.store.site import open_site

NAME = "snake"
ROWS = 142  # about 40,000 triangles

LAST = "() => Math.max(...performance.getEntriesByType('resource').filter(({name}) => name.includes('/mesh/'))"
LAST += ".map(({responseEnd}) => responseEnd))"
COUNT = "(count) => performance.getEntriesByType('resource')"
COUNT += ".filter(({name, responseEnd}) => name.includes('/mesh/') && responseEnd).length >= count"


def stl(seed: int) -> bytes:
    """A lumpy ball in binary STL."""
    up, about = np.meshgrid(np.linspace(-1.5, 1.5, ROWS), np.linspace(0.0, 2.0 * np.pi, ROWS), indexing="ij")
    far = 0.05 + 0.003 * np.sin(9.0 * up + seed) * np.cos((7 + seed) * about)
    places = np.stack([far * np.cos(up) * np.cos(about), far * np.cos(up) * np.sin(about), far * np.sin(up)], axis=-1)
    flat = places.reshape(-1, 3)
    first = (np.arange(ROWS - 1)[:, None] * ROWS + np.arange(ROWS - 1)).ravel()
    corners = np.concatenate([[first, first + 1, first + ROWS], [first + 1, first + ROWS + 1, first + ROWS]], axis=1).T
    triangles = np.zeros(len(corners), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("mark", "<u2")])
    triangles["corners"] = flat[corners]
    return b"\0" * 80 + np.uint32(len(corners)).tobytes() + triangles.tobytes()


def robot(folder: Path, links: int) -> int:
    """A chain of balls, with all files that run it; the bytes of its meshes."""
    size = 0
    for number in range(links):
        content = stl(number)
        (folder / f"ball{number}.stl").write_bytes(content)
        size += len(content)
    meshes = "".join(f'<mesh name="ball{number}" file="ball{number}.stl"/>' for number in range(links))
    body = '<site name="tip"/>'
    for number in reversed(range(links)):
        axis = ("0 0 1", "0 1 0")[number % 2]
        shape = f'<geom type="mesh" mesh="ball{number}" contype="0" conaffinity="0" mass="0.5"/>'
        joint = f'<joint name="j{number}" axis="{axis}" range="-2 2" armature="0.05"/>'
        body = f'<body name="link{number}" pos="0.12 0 0">{joint}{shape}{body}</body>'
    model = f'<mujoco><compiler angle="radian"/><asset>{meshes}</asset><worldbody>{body}</worldbody></mujoco>'
    (folder / f"{NAME}.xml").write_text(model)
    create_robot(folder / f"{NAME}.xml", folder / "base", open_site((), {}, None))
    return size


def opened(page: Page, links: int) -> float:
    """Seconds from the click until the last mesh is there."""
    button = page.get_by_role("button", name=f"Workcell {NAME}")
    button.wait_for(timeout=60_000)
    page.evaluate("() => performance.clearResourceTimings()")
    began = page.evaluate("() => performance.now()")
    button.click()
    page.wait_for_function(COUNT, arg=links, timeout=60_000)
    last: float = page.evaluate(LAST)
    return (last - began) / 1000.0


def visit(browser: Browser, address: str) -> Page:
    """Another browser."""
    page = browser.new_context(viewport={"width": 1440, "height": 900}).new_page()
    page.goto(address)
    return page


def main() -> None:
    """Measure."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--links", type=int, default=10)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as name, sync_playwright() as playwright:
        folder = Path(name)
        size = robot(folder, given.links)
        said("meshes of the world", f"{size / 2**20:.1f} MB")
        browser = playwright.chromium.launch(executable_path=path(), args=FLAGS)
        words = (f"jmove_{NAME}C", "--base", str(folder / "base"))
        with program("page", *words, "--no-forecast") as (address, _, following):
            page = visit(browser, address)
            said("the first time", f"{opened(page, given.links):.2f} s")
            for turn in ("again, the page anew", "and once more"):
                page.reload()
                time.sleep(1.0)
                said(turn, f"{opened(page, given.links):.2f} s")
            said("in another browser", f"{opened(visit(browser, following()), given.links):.2f} s")
        browser.close()


if __name__ == "__main__":
    main()
