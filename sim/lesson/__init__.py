"""QUESTIONS: what is asked, how it is marked, forms, files of answers. Standard library only.

`read_question` turns plain values (as YAML or JSON give them) into a frozen question, or raises
`LessonError` with every problem found, each with its key path and a hint. Marking is written twice,
here and in sim/web/src/question/marking; tests/marking holds the two equal.
"""

from sim.lesson.mark import Mark
from sim.lesson.problems import LessonError
from sim.lesson.question import Common, Question
from sim.lesson.read import KINDS, read_question

__all__ = ["KINDS", "Common", "LessonError", "Mark", "Question", "read_question"]
