"""Studies with people: their logs, what comes of them, the order of subjects and the papers (§6, Appendix E)."""
