import asyncio

from onika.store.mesh_folder import MeshFolder
from onika.web.page_door import KeyDoor
from onika.web.served_door import ServedDoor
from onika.web.server import bound


def test_the_door_is_opened_when_it_is_served_and_closed_with_its_socket(tmp_path):
    told, listening = [], bound(0)
    opened = ServedDoor(KeyDoor(listening, told.append), None, listening, MeshFolder(tmp_path))
    assert told == []
    asyncio.run(opened.serve((asyncio.sleep(0),)))
    assert len(told) == 1
    opened.close()
    assert listening.fileno() == -1
