/** An interaction diagram: links between objects, drawn or added from lists, and the two forces of each in words. */

import { forceOn } from "../../../../view/bodies.js";
import { tr } from "../../../../view/language.js";
import { html, need, put, say } from "../../shared/dom.js";
import { linkName } from "../marking/link-name.js";
import { Diagram } from "./diagram.js";

/** @typedef {{between: [string, string], by: string}} Link objects in the author's order */
/** @typedef {{objects: string[], focus: string[], key?: {links: Link[]}}} Facts */

/** @param {Link} link */
function words({ between: [a, b], by }) {
  return by === "contact"
    ? tr("{a} and {b} touch", { a, b })
    : tr("{a} and {b}, without touching", { a, b });
}

/** @param {HTMLElement} root @param {() => void} changed @param {Facts} facts @returns {import("../element.js").Form} */
export function interactionsForm(root, changed, { objects, focus, key }) {
  /** @type {Map<string, Link>} */
  const links = new Map(); // by their names
  /** @type {Record<string, string>} */
  let verdicts = {};
  /** @type {boolean | null} */
  let open = null; // whether it can be changed; null: nobody has said yet
  const radios = /** @type {HTMLInputElement[]} */ ([
    ...root.querySelectorAll(".carts-q-ways input"),
  ]);
  const adder = need(root, ".carts-q-add");
  const [first, how, second] = /** @type {HTMLSelectElement[]} */ ([
    ...adder.querySelectorAll("select"),
  ]);
  const add = /** @type {HTMLButtonElement} */ (need(adder, "button"));
  const list = need(root, ".carts-q-linked");
  const status = need(root, ".carts-q-picked");
  if (!first || !how || !second) throw new Error("this diagram lacks its lists");
  const way = () => radios.find((radio) => radio.checked)?.value ?? "contact";
  const name = (/** @type {Link} */ { between, by }) => linkName(objects, between, by);
  const sorted = () =>
    [...links].sort(([a], [b]) => a.localeCompare(b, "en")).map(([, link]) => link);
  const diagram = new Diagram(root, objects, (a, b) => toggle(a, b));

  /** The same line again takes it away. @param {number} a @param {number} b */
  function toggle(a, b, by = way()) {
    const link = /** @type {Link} */ ({ between: [objects[a], objects[b]], by });
    const gone = links.delete(name(link));
    if (!gone) links.set(name(link), link);
    touched(link, gone);
  }

  /** Who does not see the picture hears what was done. @param {Link} link @param {boolean} gone */
  function touched(link, gone) {
    verdicts = {};
    changed();
    show();
    const said = { link: words(link) };
    say(status, gone ? tr("Removed: {link}", said) : tr("Added: {link}", said));
  }

  function show() {
    diagram.draw(
      sorted().map((link) => {
        const [a = 0, b = 0] = link.between.map((one) => objects.indexOf(one));
        return { a, b, by: link.by, verdict: verdicts[name(link)] ?? "" };
      }),
    );
    list.replaceChildren(...sorted().map(row));
    for (const object of focus) forcesOn(object);
  }

  /** A link in words, with its two forces and a button that removes it. @param {Link} link */
  function row(link) {
    const [a, b] = link.between;
    const line = html("li");
    const verdict = verdicts[name(link)] ?? "";
    const remove = /** @type {HTMLButtonElement} */ (html("button", "carts-button", "×"));
    put(remove, "type", "button");
    put(remove, "aria-label", tr("Remove: {link}", { link: words(link) }));
    remove.disabled = add.disabled;
    remove.addEventListener("click", () => {
      links.delete(name(link));
      touched(link, true);
      const next = /** @type {HTMLElement | null} */ (list.querySelector("button"));
      (next ?? first)?.focus();
    });
    const said = html("span", "carts-q-text");
    said.append(
      html("strong", "", words(link)),
      html("span", "carts-q-pair-forces", `${forceOn(a, b)} · ${forceOn(b, a)}`),
    );
    const sign = { right: `✓ ${tr("right")}`, wrong: `✗ ${tr("not yet")}` }[verdict] ?? "";
    line.dataset.verdict = verdict;
    line.append(said, html("span", "carts-q-cell-mark", sign), remove);
    return line;
  }

  /** The strip beside the diagram. @param {string} object */
  function forcesOn(object) {
    const place = root.querySelector(`[data-focus="${CSS.escape(object)}"] ul`);
    const acting = sorted().filter(({ between }) => between.includes(object));
    place?.replaceChildren(
      ...acting.map(({ between: [a, b], by }) => {
        const line = html("li", "", forceOn(object, object === a ? b : a));
        line.classList.add(`carts-q-by-${by}`);
        return line;
      }),
    );
  }

  const choose = (/** @type {string} */ by) => {
    for (const radio of radios) radio.checked = radio.value === by;
    how.value = by;
  };
  for (const radio of radios) radio.addEventListener("change", () => choose(radio.value));
  how.addEventListener("change", () => choose(how.value));
  add.addEventListener("click", () => {
    const ends = [first, second].map((select) => objects.indexOf(select.value)).sort();
    const [a = -1, b = -1] = ends;
    if (a < 0 || a === b) return say(status, tr("Choose two different objects."));
    const known = linkName(objects, [objects[a], objects[b]], how.value);
    if (links.has(known)) return say(status, tr("This link is there already."));
    toggle(a, b, how.value);
    first.value = second.value = "";
    first.focus();
  });
  choose("contact");
  show();
  return {
    get value() {
      return links.size ? sorted() : null;
    },
    set value(value) {
      links.clear();
      verdicts = {};
      for (const link of Array.isArray(value) ? value : []) {
        const known = linkName(objects, link?.between, link?.by);
        const [a, b, by] = known.split("-");
        const between = /** @type {[string, string]} */ ([a, b].map((k) => objects[Number(k) - 1]));
        if (known) links.set(known, { between, by: String(by) });
      }
      show();
    },
    enable(on) {
      if (on === open) return; // nothing is drawn anew: who has just removed a line keeps the focus
      open = on;
      for (const one of [...radios, first, how, second, add]) one.disabled = !on;
      diagram.enable(on);
      show();
    },
    said: () => sorted().map(words).join("; "),
    marked: (shown) => {
      verdicts = Object.fromEntries(
        [...links.keys()].map((one) => [one, shown.includes(`link-${one}`) ? "right" : "wrong"]),
      );
      show();
      const lost = (key?.links ?? []).some((link) => !links.has(name(link)));
      say(status, lost ? tr("Somewhere a line is still missing.") : "");
    },
  };
}
