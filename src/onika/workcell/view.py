"""How a workcell is lit and from where it is looked at in a picture."""

from onika.workcell.part import Part

CAMERA = "picture"
"""Name of the camera."""

LOOK = (
    '<visual><global offwidth="2560" offheight="1720" fovy="32"/><quality shadowsize="8192" offsamples="8"/>'
    '<headlight ambient="0.34 0.33 0.32" diffuse="0.16 0.16 0.16" specular="0.05 0.05 0.05"/>'
    '<rgba haze="0.955 0.94 0.905 1"/><map znear="0.02" zfar="30" haze="0.5" fogstart="4" fogend="9"/></visual>'
)
"""Elements of a document that is drawn: size and fineness of pictures, daylight without direction, paper at the horizon."""


def view() -> Part:
    """The paper behind everything, two lights and a camera that sees both arms and the table."""
    return Part(
        assets='<texture type="skybox" builtin="gradient" rgb1="0.965 0.953 0.925" rgb2="0.955 0.94 0.905" '
        'width="64" height="384"/>',
        bodies='<light name="window" pos="-0.6 -2.2 2.8" dir="0.42 0.75 -1.15" directional="true" castshadow="true" '
        'diffuse="0.52 0.50 0.46" specular="0.25 0.25 0.23" ambient="0 0 0"/>'
        '<light name="wall" pos="2.8 -1.0 1.8" dir="-0.9 0.4 -0.7" directional="true" castshadow="false" '
        'diffuse="0.22 0.23 0.26" specular="0.05 0.05 0.06" ambient="0 0 0"/>'
        f'<camera name="{CAMERA}" pos="-0.75 -2.35 0.75" xyaxes="0.866 -0.5 0 0.13 0.225 0.966"/>',
    )
