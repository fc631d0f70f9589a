"""Paths of joints and of the tool that are more than one segment, or are limited, taught or joined."""
