"""The numbers of a certificate: balls and intervals, what is proved of them, zeros of functions."""
