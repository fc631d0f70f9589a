"""Everything a front end needs to run an application: begin, follow, steer, record and report."""
