"""The figure and the page element of what accuracy costs."""
