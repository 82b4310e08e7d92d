"""The page takes a wheel apart as Python's zipfile does."""

from __future__ import annotations

import base64
import io
import zipfile

from tests.web.scene.given.widget_site import in_node

FILES = {"a/__init__.pyc": b"one", "a/ü.so": bytes(range(256)), "a/empty": b""}


def archive(method: int) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", method) as target:
        for name, content in FILES.items():
            info = zipfile.ZipInfo(name)
            info.comment = b"with a comment"
            target.writestr(info, content, method)
    return out.getvalue()


def test_files_are_found_and_what_is_compressed_is_left_to_python() -> None:
    wheels = [archive(zipfile.ZIP_STORED), archive(zipfile.ZIP_DEFLATED), b"no archive at all " * 9]
    stored, *others = in_node(
        """
        const { entries } = await import(`${source}/runtime/wheel.js`);
        give(data.map((text) => {
          const found = entries(new Uint8Array(Buffer.from(text, "base64")));
          return found && [...found].map(([name, its]) => [name, [...its]]);
        }));
        """,
        [base64.b64encode(wheel).decode() for wheel in wheels],
    )
    assert {name: bytes(content) for name, content in stored} == FILES
    assert others == [None, None]
