BEGIN
  OPEN HAND opengripC
  DRIVE jmoveC TO box2_aj
  MOVE cmoveC TO box2_bx
  CLOSE HAND closegripC
  DRIVE jmoveC TO box2_aj
  DO holdsC
  CASE OF
    BEGIN
      DRIVE jmoveC TO aside
    END
    BEGIN
      OPEN HAND opengripC
    END
  END CASE
END
