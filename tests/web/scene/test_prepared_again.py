"""Prepared runs that did not come at first."""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
import struct

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
globalThis.self = globalThis;
globalThis.addEventListener = () => {};
Object.assign(globalThis, { __cartsInside: true, __cartsParts: {} });
globalThis.document = { documentElement: { lang: "en", dataset: {} } };
const { Prepared } = await import(`${source}/scene/prepared.js`);
const scene = { id: "slides", dataset: { prepared: JSON.stringify({ parts: [data.part] }) } };
const prepared = new Prepared(scene, { controls: [] }, "https://school.example/runtime/");
const said = [];
await prepared.nearest({}).catch(({ reason }) => said.push(reason));
globalThis.__cartsParts["slides.0"] = data.text;
said.push((await prepared.nearest({})).header.ok);
give(said);
"""


def test_prepared_runs_that_did_not_come_are_asked_for_again() -> None:
    text = json.dumps(
        {"axes": [], "presets": [], "headers": [{"ok": True, "rows": 1, "columns": ["t"]}]}
    )
    body = text.encode() + b" " * (-len(text) % 8)
    whole = gzip.compress(struct.pack("<II", len(body), 0) + body + struct.pack("<d", 0.5))
    part = {"src": "slides.0.js", "size": len(whole), "sha256": hashlib.sha256(whole).hexdigest()}
    told = in_node(SCRIPT, {"part": part, "text": base64.b64encode(whole).decode()})
    assert told == ["payload-damaged", True]
