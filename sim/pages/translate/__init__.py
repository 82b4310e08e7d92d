"""Lessons in other languages: their texts as units, catalogues of them, and the pages of both.

    worksheets/newtons-third-law.md                   the lesson, in English
    worksheets/words/ms/newtons-third-law.po          what its texts are in Malay
    worksheets/ms/newtons-third-law.html              the page that is made of both

Whoever writes `worksheets/ms/newtons-third-law.md` by hand has that page instead.
"""
