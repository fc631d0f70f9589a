COBEGIN
  BEGIN
    OPEN HAND opengripC
    DRIVE jmoveC TO box2_aj
    MOVE cmoveC TO box2_bx
    CLOSE HAND closegripC
    DRIVE jmoveC TO box2_aj
  END
  BEGIN
    OPEN HAND opengrip_rightC
    DRIVE jmove_rightC TO box3_ajr
    MOVE cmove_rightC TO box3_bx
    CLOSE HAND closegrip_rightC
    DRIVE jmove_rightC TO box3_ajr
  END
COEND
