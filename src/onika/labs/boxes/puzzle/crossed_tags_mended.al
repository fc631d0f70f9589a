COBEGIN
  BEGIN
    SYNCH hands
    OPEN HAND opengripC
    SYNCH arms
    DRIVE jmoveC TO aside
  END
  BEGIN
    SYNCH hands
    OPEN HAND opengrip_rightC
    SYNCH arms
    DRIVE jmove_rightC TO aside
  END
COEND
