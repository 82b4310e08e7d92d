"""Tables and summaries of classes, there and back."""
