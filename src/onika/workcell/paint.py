"""The colours of a workcell: warm paper, cream arms with orange joints, blue boxes with white signs."""

from onika.workcell.part import WorldPart

# red, green, blue, opacity; share of reflected light; shine
_PAINTS = {
    "paper": ((0.96, 0.945, 0.912, 1.0), 0.0, 0.0),
    "wood": ((0.86, 0.74, 0.56, 1.0), 0.15, 0.3),
    "wood_dark": ((0.62, 0.50, 0.35, 1.0), 0.1, 0.2),
    "cream": ((0.98, 0.96, 0.91, 1.0), 0.30, 0.6),
    "orange": ((0.98, 0.54, 0.16, 1.0), 0.4, 0.6),
    "slate": ((0.36, 0.39, 0.43, 1.0), 0.3, 0.5),
    "dark": ((0.17, 0.18, 0.20, 1.0), 0.3, 0.5),
    "steel": ((0.68, 0.70, 0.72, 1.0), 0.7, 0.8),
    "rubber": ((0.12, 0.12, 0.13, 1.0), 0.05, 0.1),
    "blue": ((0.16, 0.38, 0.84, 1.0), 0.4, 0.6),
    "white": ((0.98, 0.975, 0.96, 1.0), 0.1, 0.2),
    "brass": ((0.80, 0.62, 0.25, 1.0), 0.7, 0.7),
    "glass": ((0.93, 0.88, 0.72, 1.0), 0.8, 0.9),
    "glow": ((1.0, 0.80, 0.25, 0.0), 0.0, 0.0),
}


# the floor is paper with faint lines, lit from within so that it stays paper in the shade
_EXTRA = {"paper": ' texture="tiles" texrepeat="3.3 3.3" texuniform="true" emission="0.10"'}
_TILES = (
    '<texture name="tiles" type="2d" builtin="flat" mark="edge" rgb1="1 1 1" rgb2="1 1 1" markrgb="0.93 0.915 0.88" '
    'width="512" height="512"/>'
)


def paints() -> WorldPart:
    """All colours as materials, by name."""
    materials = "".join(
        f'<material name="{name}" rgba="{" ".join(map(str, rgba))}" specular="{specular}" shininess="{shine}"'
        f"{_EXTRA.get(name, '')}/>"
        for name, (rgba, specular, shine) in _PAINTS.items()
    )
    return WorldPart(assets=_TILES + materials)
