BEGIN
  OPEN HAND opengripC
  DRIVE jmoveC TO box2_aj
  MOVE cmoveC TO box2_bx
  CLOSE HAND closegripC
  DRIVE jmoveC TO box2_aj
  IF GRIP_MEZ[0] > 0.07 THEN
    DRIVE jmoveC TO aside
  ELSE
    DRIVE jmoveC TO home
  END IF
END
