"""Masses that can be put back to where they stood at the start (law 18)."""

from kit.worlds.mass_world import MassWorld
from onika.ring.displacement import Displacement
from onika.words.reason import Reason


class ResettableMasses(MassWorld):
    """A simulated `MassWorld` that knows which of its masses are away, and takes them back; a stop stays."""

    is_simulated = True

    def reset(self) -> None:
        """Every mass to its place, at rest."""
        for mass in self._masses.values():
            mass.state[2:] = 0.0

    def places(self) -> tuple[Reason, ...]:
        """Nothing that a person would have to put anywhere."""
        return ()

    def displaced(self) -> tuple[Displacement, ...]:
        """The masses that are more than a centimetre away."""
        away = (name for name, mass in self._masses.items() if abs(mass.state[2]) > 0.01)
        return tuple(Displacement(Reason.plain(f"{name} is away")) for name in away)
