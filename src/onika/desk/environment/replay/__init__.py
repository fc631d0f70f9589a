"""A session is rebuilt from its log (requirement H08, decision 70)."""
