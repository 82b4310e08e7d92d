"""What a class gets back on paper: a sheet for the teacher's next lesson, a slip for each student.

Both speak every language that there are words in; what students and authors wrote stays as it is.
"""
