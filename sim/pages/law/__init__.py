"""A `law` block: a page on which a reader writes a law of force, runs it and has it judged."""
