"""A still picture of a scene: for a card, a menu, a page that plays nothing."""
