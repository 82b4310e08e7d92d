/** What a reader can take along: values, pictures, a link to this state, a block for a lesson. */

import { tr } from "../../../../view/language.js";
import { html, need, say } from "../../shared/dom.js";
import { download, downloadBlob } from "../../shared/download.js";
import { asPng, picture } from "../../shared/picture.js";
import { csv } from "./csv.js";
import { qrCode } from "./qr.js";
import { linkTo, sceneBlock } from "./share.js";

/** @typedef {import("../../../../view/types.js").Run} Run */
/** @typedef {{run: Run, settings: import("./share.js").Settings, t: number, quantities: string[], seen: number}} State */

/** @type {[string, string][]} */
const KINDS = [
  ["csv", tr("values (CSV)")],
  ["svg", tr("picture (SVG)")],
  ["png", tr("picture (PNG)")],
  ["link", tr("link to this state")],
  ["block", tr("scene block")],
  ["program", tr("Python program")],
];

export class TakeAlong {
  /**
   * @param {HTMLElement} root @param {import("../../../../view/types.js").Baked} baked
   * @param {() => State} state of the scene now
   * @param {() => Promise<string>} program the scene's model as a text that Python writes
   */
  constructor(root, baked, state, program) {
    const place = need(root, ".carts-take");
    const { fence } = baked;
    const text = document.createElement("textarea");
    text.readOnly = true;
    text.hidden = true;
    text.rows = 4;
    text.setAttribute("aria-label", tr("Text to copy"));
    const note = html("p", "carts-take-note");
    note.setAttribute("role", "status");
    const row = html("p", "carts-take-row");
    for (const [key, name] of KINDS) {
      const button = html("button", "carts-button", name);
      button.setAttribute("type", "button");
      button.dataset.take = key;
      row.append(button);
    }
    const code = html("div", "carts-take-code");
    place.append(row, note, text, code);
    /** @param {string} made */
    const offer = async (made) => {
      text.hidden = false;
      text.value = made;
      text.select();
      const copied = await navigator.clipboard?.writeText(made).then(
        () => true,
        () => false,
      );
      say(note, copied ? tr("It is copied.") : tr("Copy it from the box."));
    };
    /** @type {Record<string, () => unknown>} */
    const acts = {
      csv: () => {
        const { run, quantities, seen } = state();
        const table = csv(run, quantities, fence.camera, seen);
        download(`${fence.id}.csv`, `\uFEFF${table}`, "text/csv"); // the mark tells Excel that it is UTF-8
      },
      svg: () => download(`${fence.id}.svg`, picture(root), "image/svg+xml"),
      png: async () => downloadBlob(`${fence.id}.png`, await asPng(picture(root))),
      link: () => {
        const { settings, t } = state();
        const link = `${location.href.split("#")[0]}#${linkTo(fence.id, settings, t)}`;
        code.replaceChildren(...qrCode(link));
        return offer(link);
      },
      program: async () => {
        const text = await program();
        download(`${fence.id}.py`, text, "text/x-python");
        return offer(text);
      },
      block: () => offer(sceneBlock(fence, state().settings)),
    };
    place.addEventListener("click", async (event) => {
      const button = /** @type {Element} */ (event.target).closest("button");
      const act = acts[button?.dataset.take ?? ""];
      if (!act) return;
      try {
        say(note, "");
        code.replaceChildren();
        await act();
      } catch (error) {
        const { message } = /** @type {Error} */ (error);
        say(note, tr("This browser could not do it: {why}", { why: message }));
      }
    });
  }
}
