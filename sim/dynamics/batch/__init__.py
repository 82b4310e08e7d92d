"""Many runs at once, as arrays: what maps of outcomes are made of.

* `impacts`: the closed-form outcome of isolated contacts, one numpy call for any number of them.
* `one_contact`: which points of a grid are one contact, or none, before the run ends. Only where
  that is proven is the closed form used.
* `grid`: values over one or two parameters; the points that are left are run one by one.

numpy is imported when a function here is called, not before: a page without a map never loads it.
"""
