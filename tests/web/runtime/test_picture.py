"""The picture of the memory: what is left out of it comes from the fresh instance, byte by byte."""

from __future__ import annotations

from pathlib import Path

from tests.web.scene.given.widget_site import in_node

SPARSE = Path(__file__).parents[3] / "sim" / "pages" / "runtime" / "inside" / "sparse.mjs"

# 1 MB of memory: the machine code fills some of it, a program changes some of that and writes more
# beyond; Pyodide's first steps write where the program does too, and where zeros must stand again.
SCRIPT = """
const { putPicture } = await import(`${source}/runtime/picture.js`);
const { sparse } = await import(data.sparse);
const SIZE = 1 << 20, HEAD = 48;
let seed = 1;
const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
const write = (memory, from, to, share) => {
  for (let at = from; at < to; at += 1) if (random() < share) memory[at] = 256 * random();
  return memory;
};
const fresh = write(new Uint8Array(SIZE), 1024, 300_001, 0.7);
const memory = write(write(fresh.slice(), 2000, 300_000, 0.0005), 500_000, 700_000, 0.01);
const snapshot = new Uint8Array(HEAD + SIZE);
new Uint32Array(snapshot.buffer)[1] = HEAD;
snapshot.set(memory, HEAD);
const picture = Uint8Array.from(sparse(snapshot, fresh));
const put = (into) => {
  putPicture(new Int8Array(into.buffer), picture.subarray(HEAD));
  return into;
};
const refused = (into) => { try { put(into); return false } catch { return true } };
const same = (one, other) => Buffer.compare(one, other) === 0;
const begun = write(fresh.slice(), 400_000, 600_000, 0.5);
const other = fresh.slice();
other[250_000] ^= 1;
const unkept = picture.length < snapshot.length / 2;
give([same(put(fresh.slice()), memory), same(put(begun), memory), unkept,
  refused(other), refused(new Uint8Array(SIZE / 2))]);
"""


def test_a_picture_in_a_fresh_memory_is_the_memory_it_was_taken_of() -> None:
    put, put_over, small, other_code, other_size = in_node(SCRIPT, {"sparse": SPARSE.as_uri()})
    assert put
    assert put_over
    assert small
    assert other_code
    assert other_size
