"""STATISTICS on answer files: from the students' files to an honest answer.

Nothing here knows where files come from. What needs scipy imports `scipy.special` inside the
function that uses it: a first table of means is there before scipy is.
"""
