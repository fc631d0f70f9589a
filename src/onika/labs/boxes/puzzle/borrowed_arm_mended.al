COBEGIN
  BEGIN
    OPEN HAND opengripC
    DRIVE jmoveC TO aside
  END
  BEGIN
    OPEN HAND opengrip_rightC
    DRIVE jmove_rightC TO aside
  END
COEND
