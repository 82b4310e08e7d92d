"""The report as plain values: who is counted, items, predictions, gains, what to ask about."""
