"""Answers of more students than fit into a report of names: as a table, and the report from it.

A class is read file by file into memory, with every student by name. A country is not. Here answer
files become rows of one flat table (`schema`, `rows`, `write`), a file at a time, and an expression
over that table (`counted`, `cells`) makes the counts from which `sim.classroom.summary` computes
every number. The expression is written once, in Ibis; DuckDB works it out on disk, and so does
whatever else Ibis knows (`backend`).

Why the numbers are equal to those of the files: marks are whole numbers, so a count of students by
what they did (marks in an item, total, option) loses nothing that a statistic asks for. The counts
are summed exactly, by the code that sums files and tables.

Needs the extra `country`. Nothing else of the project imports any of it.
"""
