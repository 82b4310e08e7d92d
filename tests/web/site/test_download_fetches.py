"""“Download this lesson” asks the server, not the browser's store, for scripts that it names."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
globalThis.document = {
  baseURI: "https://school.example/worksheets/a.html",
  documentElement: { lang: "en" },
  createElement: () => ({
    setAttribute() {}, append() {}, addEventListener(kind, does) { this.does = does; },
  }),
};
globalThis.location = { pathname: "/worksheets/a.html" };
const asked = [];
globalThis.fetch = async (address, options) => {
  asked.push([String(address), options?.cache]);
  const text = address.pathname.endsWith(".txt") ? data : "script";
  return { ok: true, text: async () => text };
};
let button;
const make = document.createElement;
document.createElement = (name) => {
  const made = make(name);
  if (name === "button") button = made;
  return made;
};
const { downloadLine } = await import(`${source}/hosted/download.js`);
downloadLine("../assets/carts/download/a.txt", "https://school.example/assets/carts/");
await button.does().catch(() => {});
give(asked);
"""


def test_a_script_of_an_earlier_version_is_not_put_in() -> None:
    shell = '<script data-from="carts.js"></script> and <script data-from="answers.js"></script>'
    assets = "https://school.example/assets/carts/"
    assert sorted(in_node(SCRIPT, shell)) == sorted(
        [f"{assets}{name}", "no-cache"]
        for name in ("answers.js", "carts.js", "download/a.txt")
    )  # fmt: skip


DROPPED = (
    SCRIPT.replace("globalThis.location = {", 'globalThis.location = { protocol: "https:",')
    .replace(
        "asked.push([String(address), options?.cache]);",
        """asked.push(String(address));
  most = Math.max(most, ++under);
  await new Promise((done) => setTimeout(done, 5));
  under -= 1;
  const first = address.pathname.endsWith("part.1.js") && !dropped;
  dropped ||= first;
  if (first) throw new TypeError("Failed to fetch");""",
    )
    .replace("const asked = [];", "const asked = [];\nlet [under, most, dropped] = [0, 0, false];")
    .replace("give(asked);", "give({ most, asked });")
)


def test_a_slow_network_is_asked_for_two_files_at_once_and_again_for_one_that_it_dropped() -> None:
    names = [f"part.{k}.js" for k in range(6)]
    shell = " ".join(f'<script data-from="{name}"></script>' for name in names)
    done = in_node(DROPPED, shell)
    assert done["most"] == 2
    assert sorted({one.rpartition("/")[2] for one in done["asked"]}) == ["a.txt", *names]
    assert len(done["asked"]) == len(names) + 2
