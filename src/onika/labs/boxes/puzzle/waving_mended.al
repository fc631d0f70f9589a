BEGIN
  OPEN HAND opengripC
  DRIVE jmoveC TO box2_aj
  MOVE cmoveC TO box2_bx
  CLOSE HAND closegripC
  DRIVE jmoveC TO box2_aj
  DRIVE jmoveC TO box1_aj
END
