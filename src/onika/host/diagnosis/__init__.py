"""Why a run stands still or ends, found as it happens."""
