BEGIN
  DRIVE jmoveC TO box2_aj
  MOVE cshiftC TO up_10cm
  REPEAT up
    NOP noop
    DO repeatC TO three
  UNTIL DONE
END
