"""The page's server: sign-in, one socket per browser, and the built page itself."""
