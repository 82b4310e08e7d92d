"""Bytes of a file to texts: a text, or what lies in a zip.

phyphox zips its CSV with notes on the device; Tracker zips a project with its film. Taken is the
one member that holds readings; nothing is unpacked beyond MOST_BYTES.
"""

from __future__ import annotations

from sim.measured.refusal import refuse
from sim.measured.sheet.cells import MOST_BYTES, decoded
from sim.scene.said import said

MOST_ZIPPED = 30_000_000
"""Bytes: a film is in it."""

SUFFIXES = (".csv", ".txt", ".tsv", ".trk")
ASIDE = ("meta/", "__MACOSX/")
WORKBOOKS = ("xl/workbook.xml", "xl/workbook.bin", "content.xml", "Index/Document.iwa")
"""What is in a workbook of Excel, LibreOffice and Numbers, which are zips too."""

OLD_WORKBOOK = b"\xd0\xcf\x11\xe0"
NO_TABLE = (
    said("this is a workbook of a spreadsheet and no table of text"),
    said("open it and save its sheet as CSV: File, Save as, CSV UTF-8"),
)


def texts_of(content: bytes) -> list[str]:
    """One text; raises ReadingError."""
    if content[:4] == OLD_WORKBOOK:
        raise refuse(1, *NO_TABLE)
    if content[:4] != b"PK\x03\x04":
        return [decoded(content)]
    if len(content) > MOST_ZIPPED:
        raise refuse(1, said("this zip is larger than 30 MB"), said("unpack it and take the table"))
    return [decoded(_unzipped(content))]


def _rank(name: str) -> int:
    """A project before its exported table, and a text, which may be a remark, last."""
    return (".trk", ".csv", ".tsv", ".txt").index(name.lower()[-4:])


def _unzipped(content: bytes) -> bytes:
    import io
    import zipfile
    import zlib

    try:
        with zipfile.ZipFile(io.BytesIO(content)) as pack:
            if set(WORKBOOKS) & set(pack.namelist()):
                raise refuse(1, *NO_TABLE)
            names = [
                name
                for name in pack.namelist()
                if name.lower().endswith(SUFFIXES) and not name.startswith(ASIDE)
            ]
            names.sort(key=_rank)
            if not names:
                raise refuse(1, said("no table is in this zip"), said("export as CSV"))
            with pack.open(names[0]) as member:
                return member.read(MOST_BYTES + 1)
    except NotImplementedError:
        reason = said("this zip is packed in a way that is not read")
        raise refuse(1, reason, said("unpack it")) from None
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, RuntimeError, ValueError) as error:
        if hasattr(error, "faults"):
            raise
        raise refuse(1, said("this zip is damaged or locked"), said("export it anew")) from None
