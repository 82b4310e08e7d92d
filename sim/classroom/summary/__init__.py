"""A class as exact sums: what a report is computed from, and what may leave a school."""
