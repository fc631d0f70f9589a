"""From files to a plan: an application is compiled, redirected, written as text, made an icon."""
