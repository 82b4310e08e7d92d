"""Blocks of a lesson: from the fence in its Markdown to a described scene and to its HTML."""
