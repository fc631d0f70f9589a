"""A package, so that Chromium is let go when its last test is over.

While Playwright lives, its thread has an event loop, and no other test could start one.
"""
