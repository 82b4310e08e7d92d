"""What an author is told without building: every mistake in lessons, and hints about scenes."""
