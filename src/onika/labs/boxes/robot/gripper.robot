VERSION     2.0
DESC        a hand of two coupled fingers, driven by compressed air
FILE        gripper.xml

GRIPPER     gripper
MOVES       valve1 valve2
DRIVE       signal
OPEN        1 0.112
CLOSED      -1 0.06
FORCE       touch1 touch2

EOF
