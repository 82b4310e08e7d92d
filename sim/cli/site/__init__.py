"""Commands that make a site, show it and pack it."""
