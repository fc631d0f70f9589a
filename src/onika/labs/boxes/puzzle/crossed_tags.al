COBEGIN
  BEGIN
    SYNCH hands
    OPEN HAND opengripC
    SYNCH arms
    DRIVE jmoveC TO aside
  END
  BEGIN
    SYNCH arms
    OPEN HAND opengrip_rightC
    SYNCH hands
    DRIVE jmove_rightC TO aside
  END
COEND
