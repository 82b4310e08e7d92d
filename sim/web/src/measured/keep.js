/** What a reader opened, typed and set on this page is kept in the browser, apart from the answers. */

import { need } from "../shared/dom.js";
import { KeptLine } from "../store/kept-line.js";
import { openAll, place, READINGS } from "../store/storage.js";

/** @typedef {import("../../../view/measured/types.js").Kept} Kept */

/** @param {string} id of the block @param {HTMLElement} bench that says when something is not kept */
export function keeper(id, bench) {
  const line = new KeptLine(bench);
  need(bench, ".carts-measured-source").append(line.root);
  const { site, page } = place();
  const key = `${page}/${id}`;
  const opened = openAll(`${site}${READINGS}`);
  /** @param {Kept} kept @returns {Promise<boolean>} whether the browser says that it is kept */
  const put = async (kept) => {
    try {
      const store = await opened;
      await store.put(key, kept, true);
      return store.kind === "kept";
    } catch {
      return false;
    }
  };
  return {
    /** @returns {Promise<Kept | null>} */
    get: async () => (await opened).get(key).catch(() => null),
    /** Of a lesson's own readings nothing is lost, so nothing is said. @param {Kept} kept */
    put: (kept) => {
      const done = put(kept);
      const own = kept.texts.length || kept.cells.length || kept.pasted;
      void line.hear(own ? done : Promise.resolve(true));
    },
  };
}

/** What is kept where nothing was done yet. @param {import("../../../view/measured/types.js").Facts} facts @returns {import("../../../view/measured/types.js").Kept} */
export function empty(facts) {
  return {
    name: "",
    texts: [],
    cells: [],
    units: facts.units ?? { length: "", time: "", force: "" },
    from: "",
    until: "",
    law: facts.law,
    effect: usual([], facts),
    distance: "",
    masses: ["", ""],
    hand: null,
    fitted: "",
  };
}

/** What is fitted beside the contact, where nobody has chosen: what the reader's own readings call for; of a lesson's it is a question. @param {string[]} texts opened by the reader @param {import("../../../view/measured/types.js").Facts} facts */
export const usual = (texts, facts) => (facts.text && !texts.length ? "none" : "called");

/** The readings that count: what the reader opened, or the lesson's own, which a program may have made. @param {Kept} kept @param {import("../../../view/measured/types.js").Facts} facts */
export function readings(kept, facts) {
  if (kept.texts?.length) return { texts: kept.texts, synthetic: false, own: true };
  return { texts: facts.text ? [facts.text] : [], synthetic: facts.synthetic, own: false };
}
