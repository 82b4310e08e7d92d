"""A text of readings as a table: cells, heads of columns, whose they are, several runs."""
