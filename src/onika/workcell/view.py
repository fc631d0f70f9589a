"""How a workcell is lit and from where it is looked at in a picture."""

import numpy as np

from onika.laws.chain import text_of
from onika.workcell.part import WorldPart

CAMERA = "picture"
"""Name of the camera."""

LOOK = (
    '<visual><global offwidth="2560" offheight="1720" fovy="30"/><quality shadowsize="8192" offsamples="8"/>'
    '<headlight ambient="0.36 0.355 0.35" diffuse="0.12 0.12 0.12" specular="0.04 0.04 0.04"/>'
    '<rgba haze="0.972 0.963 0.942 1"/>'
    '<map znear="0.02" zfar="40" haze="0.6" shadowclip="1" shadowscale="0.9"/></visual>'
    '<statistic center="0.6 0 -0.2" extent="1.6"/>'
)
"""What a document that is drawn says first: fineness of the picture, soft daylight, paper at the horizon."""

# the eye and the point it looks at, in the world, for one arm and for two
_ONE_ARM = ((-0.74, -1.55, 0.50), (0.41, 0.0, -0.16))
_TWO_ARMS = ((-0.68, -2.42, 0.84), (0.63, 0.0, 0.08))

_LIGHTS = (
    '<light name="window" pos="-0.4 -1.9 2.6" dir="0.38 0.95 -1.20" directional="true" castshadow="true" '
    'diffuse="0.52 0.51 0.49" specular="0.25 0.25 0.23" ambient="0 0 0"/>'
    '<light name="wall" pos="2.8 -1.0 1.8" dir="-0.9 0.35 -0.6" directional="true" castshadow="false" '
    'diffuse="0.20 0.21 0.24" specular="0.05 0.05 0.06" ambient="0 0 0"/>'
)


def view(arms: int) -> WorldPart:
    """The paper behind everything, two lights and a camera that sees `arms` arms and the table."""
    return WorldPart(
        assets='<texture type="skybox" builtin="gradient" rgb1="0.965 0.955 0.932" rgb2="0.972 0.963 0.942" '
        'width="64" height="384"/>',
        bodies=_LIGHTS + _camera(*(_TWO_ARMS if arms > 1 else _ONE_ARM)),
    )


def _camera(eye: tuple[float, float, float], middle: tuple[float, float, float]) -> str:
    back = np.subtract(eye, middle)
    right = np.cross((0.0, 0.0, 1.0), back)
    return f'<camera name="{CAMERA}" pos="{text_of(eye)}" xyaxes="{text_of(right)} {text_of(np.cross(back, right))}"/>'
