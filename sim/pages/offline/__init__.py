"""Sites without a network. A hosted one is an app: it opens after the first visit, can be
installed, and shows what it is where somebody sends a link. One for double click needs none of
this: its folder has a page that says what to open.
"""

from sim.pages.offline.hosting import Hosting

__all__ = ["Hosting"]
