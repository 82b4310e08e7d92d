"""Pages about classes: the paper's tables, computed when the site is built."""
