"""What a teacher takes home: the changed lesson, what was changed in it, and where it goes."""

from __future__ import annotations

import difflib
import io
import re
import zipfile
from base64 import b64encode
from pathlib import PurePosixPath

DATE = (1980, 1, 1, 0, 0, 0)  # equal files are equal to the last byte
LINE = re.compile(r"[^\n]*\n|[^\n]+")  # as programs for versions count them
NO_LINE_END = "\\ No newline at end of file\n"
NOTE = """\
{file}      the changed lesson: put it in this place in the folder of your site
changes.diff      what was changed, line by line

Then look for mistakes and build the site:

    carts check {file}
    carts build

Lessons are published under CC BY 4.0: name where the lesson comes from.
"""


def changes(file: str, text: str, published: str) -> str:
    """The difference from the published text, in the form that programs for versions read."""
    before, after = (LINE.findall(one) for one in (published, text))
    rows = difflib.unified_diff(before, after, f"a/{file}", f"b/{file}")
    return "".join(row if row.endswith("\n") else f"{row}\n{NO_LINE_END}" for row in rows)


def zipped(file: str, text: str, published: str) -> str:
    """A zip in base64; `file` is the lesson's path in its site."""
    target = io.BytesIO()
    name = PurePosixPath(file).name
    content = {
        f"{name.removesuffix('.md')}/{file}": text,
        f"{name.removesuffix('.md')}/changes.diff": changes(file, text, published),
        f"{name.removesuffix('.md')}/READ-ME.txt": NOTE.format(file=file),
    }
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, written in content.items():
            info = zipfile.ZipInfo(path, DATE)
            info.external_attr = 0o644 << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(info, written.encode("utf-8"))
    return b64encode(target.getvalue()).decode("ascii")
