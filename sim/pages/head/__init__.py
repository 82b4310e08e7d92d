"""The head of a page: what it may run, what it needs, and who watches that it runs."""
