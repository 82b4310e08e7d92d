"""Pages and lessons in other languages."""
