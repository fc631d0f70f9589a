"""Parts of a runtime by themselves, without processes: a rig for each."""
