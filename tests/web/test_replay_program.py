import asyncio
import json

import pytest

from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.replay import replay_place
from onika.desk.environment.replay.replay_control import ReplayControl
from onika.desk.environment.replay.session_player import SessionPlayer
from onika.files.state import session_log
from onika.web.replay_program import NoValues, ReplayProgram
from onika.web.server import bound
from onika.wire import act

LINES = [
    ("Start_Onika", '{"s":"a","n":0,"start":{}}'),
    ("new_conf", json.dumps({"s": "a", "n": 1, "act": {"t": "New"}, "by": 0, "value": "c1"})),
]


@pytest.fixture
def player(tmp_path):
    text = "\n".join(
        session_log.line((f"{number}.0", event, "none", "0", "none", "0", "root"), record)
        for number, (event, record) in enumerate(LINES)
    )
    lines, faults = session_log.read(text, "s.log")
    assert faults == ()
    control = ReplayControl(lambda: 0.0, "s.log", 1000.0)
    place = replay_place.made(lines, [], tmp_path / "replay", "s.log")
    player = SessionPlayer(lines, place, {**HANDLERS, act.SteerReplay: control.steer}, "s.log")
    player.control = control
    return player


def test_a_session_is_played_while_its_page_is_served(player):  # R-H08
    addresses = []

    async def until_over():
        running = asyncio.ensure_future(ReplayProgram(player, player.control).run(bound(0), addresses.append))
        while not addresses:
            await asyncio.sleep(0)
        player.environment.do(act.SteerReplay("end"), "me", lambda _: None)
        while not player.is_over:
            await asyncio.sleep(0)
        running.cancel()
        await asyncio.gather(running, return_exceptions=True)

    asyncio.run(until_over())
    assert addresses[0].startswith("http://")
    assert list(player.environment.model.documents) == ["c1"] and player.faults == []


def test_a_replay_has_no_values():  # R-H08
    NoValues().watch(frozenset(), frozenset(), False, 1.0)
    assert NoValues().frame() is None
