"""A hosted site as an app: it opens without a network after the first visit, can be installed, and
shows what it is where somebody sends a link. A site for double click needs none of this.
"""

from sim.pages.offline.hosting import Hosting

__all__ = ["Hosting"]
