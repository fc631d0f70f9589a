from kit.labs.laboratory import job
from onika.desk.environment.file.recordings_folder import recordings_folder
from onika.record.black_box_folder import black_boxes_in
from onika.wire import act


def test_recordings_are_listed_newest_first_and_nothing_else(cinema):  # R-X05
    doc = cinema.open([job("aC")])
    folder = recordings_folder(cinema.surroundings.state)
    assert cinema.later(act.Recordings()).value.files == ()
    folder.mkdir(parents=True)
    whole, cut = cinema.film(doc), cinema.film(doc, "cut", ends=False)
    whole.rename(folder / "whole.mcap")
    cut.rename(folder / "cut.mcap")
    (folder / "odd.mcap").write_text("nothing")
    listing = cinema.later(act.Recordings()).value
    assert listing.folder == str(folder)
    by_name = {file.path.rpartition("/")[2]: file for file in listing.files}
    assert sorted(by_name) == ["cut.mcap", "whole.mcap"]
    file = by_name["whole.mcap"]
    assert (file.name, file.took_s, file.is_whole) == ("play", 1.0, True)
    assert not by_name["cut.mcap"].is_whole
    assert file.bytes == (folder / "whole.mcap").stat().st_size
    assert file.began_at_s > 1.7e9


def test_black_boxes_are_listed_among_them_and_marked(cinema):  # R-X05
    doc = cinema.open([job("aC")])
    boxes, folder = black_boxes_in(cinema.surroundings.state), recordings_folder(cinema.surroundings.state)
    for path in (boxes, folder):
        path.mkdir(parents=True)
    cinema.film(doc, "box", held_s=(0.4, 1.0)).rename(boxes / "play-20261121-231500-77-1.mcap")
    cinema.film(doc, "whole").rename(folder / "whole.mcap")
    by_path = {file.path: file for file in cinema.later(act.Recordings()).value.files}
    box, whole = by_path[str(boxes / "play-20261121-231500-77-1.mcap")], by_path[str(folder / "whole.mcap")]
    assert (box.is_black_box, round(box.took_s, 3)) == (True, 0.6)
    assert (whole.is_black_box, whole.took_s) == (False, 1.0)
