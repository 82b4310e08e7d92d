"""What happened in a film or a log: segments, contacts, and what each contact was."""
