"""Onika: a visual programming environment for robots and other real-time control systems."""

__version__ = "0.1.0"
