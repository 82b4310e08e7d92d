"""Old Chromium as npm has it: packages made for a computing service, a browser in each.

Each file counts only if its sha256 is the one below. About 320 MB come once, into the cache.
"""

from __future__ import annotations

import hashlib
import subprocess
import tarfile
from pathlib import Path

from sim.pages.runtime import default_cache
from sim.pages.runtime.node import node_program

ROOT = Path(__file__).parents[3]
# Version of the browser: package, its version, sha256 of what npm delivers.
PACKAGES = {
    80: ("chrome-aws-lambda", "2.1.1",
         "94f8953cd47c3fbd9d0ba8f50d2e5aa4e8136ca52b37e2babcc12e43018ade77"),
    91: ("chrome-aws-lambda", "9.1.0",
         "18d7c042802093f851a91e3b09fb417639ab4cfa33cc5a8ebbc92df7d15b0601"),
    103: ("@sparticuz/chromium", "103.0.0",
          "88f1af268022584ffd0e4b58a68c8bd63b55f247b7c84481c719f362fb2be43a"),
    106: ("@sparticuz/chromium", "106.0.2",
          "4663c26edf8d2888a5dc6055799cfc90e5041449e11bd9f31cab560c086a93d8"),
    109: ("@sparticuz/chromium", "109.0.6",
          "84171b067a588137a242c3dfb70d160c49d055a4227297aefc5eace94e47566c"),
    119: ("@sparticuz/chromium", "119.0.2",
          "dd80591c6748586980ba09af9357e2d428fbe1a448641f30bad020d36490a19f"),
}  # fmt: skip
UNPACK = """const [from, to] = process.argv.slice(1), fs = require("fs");
fs.writeFileSync(to, require("zlib").brotliDecompressSync(fs.readFileSync(from)), { mode: 0o755 });
"""


def program(version: int) -> Path:
    """The browser's program. Raises RuntimeError where it can't be had, or is another file."""
    package, release, wanted = PACKAGES[version]
    folder = default_cache(ROOT) / "old-browsers" / str(version)
    made = folder / "chromium"
    if made.exists():
        return made
    folder.mkdir(parents=True, exist_ok=True)
    archive = _fetch(f"{package}@{release}", folder)
    if hashlib.sha256(archive.read_bytes()).hexdigest() != wanted:
        raise RuntimeError(f"{package} {release} is not the file that was looked at: not unpacked")
    packed = folder / "chromium.br"
    with tarfile.open(archive) as tar, packed.open("wb") as out:
        inside = tar.extractfile("package/bin/chromium.br")
        assert inside is not None
        out.write(inside.read())
    subprocess.run([str(node_program()), "-e", UNPACK, str(packed), str(made)], check=True)
    packed.unlink()
    archive.unlink()
    return made


def _fetch(name: str, folder: Path) -> Path:
    print(f"Downloading {name} from npm", flush=True)
    node = node_program()
    npm = node.parents[1] / "lib" / "node_modules" / "npm" / "bin" / "npm-cli.js"
    done = subprocess.run(
        [str(node), str(npm), "pack", "--silent", name],
        cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip
    if done.returncode:
        raise RuntimeError(f"{name} can't be had: {done.stderr.strip()[-200:]}")
    return folder / done.stdout.split()[-1]
