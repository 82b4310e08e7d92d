"""An author's text: where blocks stand in it, and YAML with places and readable mistakes."""
