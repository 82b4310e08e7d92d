/** Whether a reader's arrows belong to a world: the same one of the two is longer, and not in ours. */

import { ALIKE } from "../predict/arrow-parts.js";
import { openStore, place } from "../store/storage.js";
import { greatestOn } from "./ends.js";

/** @typedef {import("../../../view/types.js").Run} Run */

/** @param {import("../../../view/types.js").Baked} baked @param {Run} world */
export async function isYours({ fence }, world) {
  if (fence.predict?.kind !== "arrows") return false;
  const { site, page } = place();
  const store = await openStore(site);
  const entry = await store.get(`${page}#${fence.id}`).catch(() => null);
  const arrows = Array.isArray(entry?.value) ? entry.value : [];
  return fence.predict.pairs.some(([left, right]) => {
    const pair = `${left}-${right}`;
    const said = [left, right].map((on) => {
      const arrow = arrows.find((/** @type {any} */ one) => one.pair === pair && one.on === on);
      return Number(arrow?.share ?? arrow?.size ?? Number.NaN);
    });
    const order = compared(Number(said[0]), Number(said[1]));
    const there = compared(greatestOn(world, pair, left), greatestOn(world, pair, right));
    return order !== 0 && order === there;
  });
}

/** 1: the first is larger, −1: the second, 0: alike, or one is missing. @param {number} a @param {number} b */
function compared(a, b) {
  if (!(Math.abs(a - b) > ALIKE * Math.max(a, b))) return 0;
  return a > b ? 1 : -1;
}
