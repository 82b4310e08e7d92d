"""The site as a whole: MkDocs' plugin, what every site has, which files join it, its settings."""
