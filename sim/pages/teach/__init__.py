"""Teacher mode: a lesson is changed in its own page, checked and shown as the build would.

What lies here runs in the page, in a Python package that only teacher mode loads (`answer.py` is
its door), but for `publish.py`, which hands a lesson's text to its page. How and why:
docs/developers/teacher-mode.md.
"""
