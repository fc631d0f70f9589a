"""A press of a button that begins after somebody started to look."""


class NewPress:
    """What is pressed already counts only once it has been let go and is pressed again."""

    def __init__(self, is_pressed: bool) -> None:
        self._was_free = not is_pressed

    def is_there(self, is_pressed: bool) -> bool:
        """Whether the button is pressed anew, as it is now."""
        self._was_free = self._was_free or not is_pressed
        return is_pressed and self._was_free
