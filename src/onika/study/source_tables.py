"""Tables 1 to 3 of the source as the folder of a study, which the report reads like any other (§6.2.4; H03)."""

from pathlib import Path

FOLDER = Path(__file__).with_name("source")
MEAN_SELECTION_S = 6.1
"""Of the group with pictures and words (H06)."""
BUILDING_S = (257.0, 868.0)
"""Least and most of that group, without the time of runs."""
