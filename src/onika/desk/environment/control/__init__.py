"""Acts about who may move the robots, and who else is there."""
