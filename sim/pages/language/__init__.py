"""Interface words in the reader's language. An English sentence is its own key.

Lessons are written in whatever language their author chooses. What stands around them (buttons,
readouts, sentences about a run) is English in the code, `tr("Step back")`, and comes out in the
language of the page. Catalogues are gettext's `.po` files, which translators have tools for.
`sim/view/language.js` does the same in the page, with a script that `words_script` writes.
"""

from sim.pages.language.catalogue import (
    ENGLISH,
    LANGUAGES,
    OWN,
    UnknownLanguageError,
    language_folder,
    language_of,
    of_page,
    own_words_script,
    words,
    words_of,
    words_script,
)
from sim.pages.language.say import (
    mark,
    speaking,
    spoken,
    told,
    told_if_ours,
    tr,
    tr_counted,
    tr_html,
)

__all__ = [
    "ENGLISH",
    "LANGUAGES",
    "OWN",
    "UnknownLanguageError",
    "language_folder",
    "language_of",
    "mark",
    "of_page",
    "own_words_script",
    "speaking",
    "spoken",
    "told",
    "told_if_ours",
    "tr",
    "tr_counted",
    "tr_html",
    "words",
    "words_of",
    "words_script",
]
