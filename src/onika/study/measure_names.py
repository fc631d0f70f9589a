"""The figures in which groups are compared, and those that a table of results may give without a log (H03)."""

COMPARED = ("mean_selection_s", "building_s", "deletions", "attempts")
"""The first is the one that the source compared; the others are the further columns of its tables 1 to 3."""
