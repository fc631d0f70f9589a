VERSION     2.0
DESC        the bridge over a bench, which measures how far the ground is below its gripper
FILE        gantry.xml

ARM         arm
TOOL        tip
HOME        0 0 0 0
# in m/s, and of the wrist in rad/s: no MJCF says them
SPEED       0.5 0.5 0.4 2

SENSOR      range
READS       range

EOF
