"""What is measured, as a block in the file of a robot or of a world (requirement X19)."""

from onika.files.block_words import BlockWords
from onika.files.line import row
from onika.files.text_reading import KeywordSlot, Need
from onika.model.robot import SensorBlock
from onika.words.reason import Reason

SLOTS = (KeywordSlot("SENSOR"), KeywordSlot("READS", Need.OPTIONAL), KeywordSlot("POSE", Need.OPTIONAL))


def read_sensor(words: BlockWords) -> SensorBlock:
    """What a block measures: some sensors, or the pose of one body."""
    reads = words.words("READS", Reason.of("files.names_of_sensors"))
    body = words.word("POSE", Reason.of("files.name_of_body"))
    if words.has("READS") == words.has("POSE"):
        words.wrong("SENSOR", Reason.of("files.reads_or_pose"))
    return SensorBlock(words.name("SENSOR"), reads, body, words.lines)


def show_sensor(sensor: SensorBlock) -> str:
    """The lines of what is measured."""
    what = row("POSE", sensor.body) if sensor.body else row("READS", *sensor.reads)
    return row("SENSOR", sensor.name) + what
