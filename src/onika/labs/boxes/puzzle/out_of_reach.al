BEGIN
  OPEN HAND opengripC
  DRIVE jmoveC TO box2_aj (0.181442 -0.625356 4.2 0.0 1.06636 1.752238; duration=2.3)
  MOVE cmoveC TO box2_bx
  CLOSE HAND closegripC
  DRIVE jmoveC TO box2_aj
END
