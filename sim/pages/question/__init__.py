"""Questions and forms in a page: from a block of a lesson to HTML."""

from sim.pages.question.block import QuestionBlock, read_question_block
from sim.pages.question.on_page import PageItems
from sim.pages.question.quiz import QuizBlock, read_quiz_block

__all__ = ["PageItems", "QuestionBlock", "QuizBlock", "read_question_block", "read_quiz_block"]
