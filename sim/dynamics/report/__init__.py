"""A finished run in words and as JSON: plan, reasons, warnings."""
