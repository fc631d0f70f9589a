"""Texts of a site: what may be launched there."""
