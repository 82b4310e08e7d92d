"""Numbers of a class, each with what must be true for it to be given."""
