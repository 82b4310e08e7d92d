"""What a class gets back on paper: a sheet for the next lesson, a slip for each student, the key.

All speak every language that there are words in; what students and authors wrote stays as it is.
"""
