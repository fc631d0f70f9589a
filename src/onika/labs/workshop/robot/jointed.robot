VERSION     2.0
DESC        an arm of six joints that takes positions and speeds, with a gripper
FILE        jointed.xml

ARM         arm
TOOL        tip
HOME        0 0.4 1.3 0 1.2 0
SPEED       2 2 2 3 3 3

GRIPPER     gripper
MOVES       squeeze
# 12 mm are between the fingers when they are closed
OPEN        0.03 0.072
CLOSED      0 0.012

SENSOR      wrench
READS       wrist_force wrist_torque

EOF
