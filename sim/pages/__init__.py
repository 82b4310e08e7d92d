"""GENERATOR: from a teacher's Markdown file to a page of the offline site.

Everything that thinks is a pure function from text to text; the Markdown extension and the MkDocs
plugin are thin shells around them, so that the site generator can be exchanged. What each room here
is for: docs/developers/generator.md.
"""
