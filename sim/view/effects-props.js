/** What effects look like besides their forces: pieces of the picture, each known by its key. */

import { actsAt, viewOf } from "./effects.js";

/** @typedef {import("./types.js").Layout} Layout */
/** @typedef {import("./types.js").Piece} Piece */
/** @typedef {import("./types.js").Face} Face */
/** @typedef {import("./types.js").Centre} Centre */

/** @param {import("./types.js").Effect} effect @param {number} t in s @returns {boolean} whether it is in the picture */
function isSeen(effect, t) {
  const { seen } = viewOf(effect.kind);
  return seen ? effect.active && seen(effect, t) : actsAt(effect, t);
}

/** The pieces of all effects that act. */
/** @param {import("./types.js").Run} run @param {Layout} layout @param {number} t in s @param {Face} face @param {Centre} centre @returns {Piece[]} */
export function props(run, layout, t, face, centre) {
  const { header } = run;
  return header.effects
    .filter((effect) => isSeen(effect, t))
    .flatMap((effect) => {
      const key = `${effect.kind} ${effect.index}`;
      return (
        viewOf(effect.kind).pieces?.(effect, { key, header, run, t, layout, face, centre }) ?? []
      );
    });
}
