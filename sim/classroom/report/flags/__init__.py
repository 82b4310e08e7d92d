"""What a teacher should look at before counting, and which files count."""
