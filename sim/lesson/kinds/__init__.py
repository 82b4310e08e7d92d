"""The kinds of questions, one class each."""
