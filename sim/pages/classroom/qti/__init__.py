"""QTI 3.0: the questions of a bank as a package that assessment systems read.

A zip with a manifest, a test and a file for each item. Response processing is written out, not a
template, so that an item gives its marks as these pages do: as a whole, with feedback on what was
chosen or typed. Source: 1EdTech, Question and Test Interoperability 3.0 (2022).
"""
