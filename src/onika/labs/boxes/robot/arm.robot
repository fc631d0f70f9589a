VERSION     2.0
DESC        the PUMA 560, an arm of six joints that takes torques
KIND        puma560
FILE        puma560.xml

ARM         arm
# the point between the fingers of the hand, 130 mm beyond the flange
TOOL        flange 0 0 0.13
DRIVE       torque
HOME        0 -1.5707963267948966 1.5707963267948966 0 0 0
SPEED       1.4311699866353502 1.2915436464758039 2.129301687433082 3.9793506945470716 4.2062434973063345 3.9793506945470716
TORQUE      97.6 186.4 89.4 24.2 20.1 21.3
# gains of the joint servo, N m/rad and N m s/rad, by which the drive holds
KP          4000 6000 2500 500 400 300
KD          213 382 99 20 18 16

EOF
