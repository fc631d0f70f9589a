VERSION     2.0
DESC        an Adept One-like SCARA that takes torques
KIND        adept_one
FILE        adept_one.xml

ARM         arm
# the point between the fingers of the hand, 130 mm beyond the flange
TOOL        flange 0 0 0.13
DRIVE       torque
HOME        -1.7453292519943295 2.0943951023931953 0 -1.2217304763960306
SPEED       2.6179938779914944 3.490658503988659 0.6 6.283185307179586
TORQUE      300 150 600 20
# gains of the joint servo, N m/rad and N m s/rad, by which the drive holds
KP          6000 4000 40000 300
KD          400 200 1400 15

EOF
