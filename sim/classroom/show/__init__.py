"""The report as HTML: the same in the page, in a saved file and on paper."""
