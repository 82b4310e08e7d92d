"""Old Chromium, as on laptops that a school has had for ten years: `make test-old`."""
