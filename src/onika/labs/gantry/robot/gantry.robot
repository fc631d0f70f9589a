VERSION     2.0
DESC        a bridge over a bench: three slides, a wrist and a gripper
FILE        gantry.xml

ARM         arm
TOOL        tip
HOME        0 0 0 0
# in m/s, and of the wrist in rad/s: no MJCF says them
SPEED       0.5 0.5 0.4 2

GRIPPER     gripper
MOVES       squeeze
# the signal of `squeeze` is the way of one finger; 24 mm are between them when they are closed
OPEN        0.04 0.104
CLOSED      0 0.024

CAMERA      wrist

EOF
