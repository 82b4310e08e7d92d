/** What a cart can do, in words. */

import { tr } from "../../../view/language.js";

/** @type {Record<string, () => string>} */
const KINDS = {
  rest: () => tr("rest"),
  hand: () => tr("hand"),
  coasting: () => tr("coasting"),
  friction: () => tr("slowing down"),
  contact: () => tr("contact"),
  stop: () => tr("stop"),
};
/** @param {string} kind @returns {string} in the reader’s language */
export const word = (kind) => KINDS[kind]?.() ?? kind;

export const hint = () =>
  tr(
    "What each cart did. Drag a boundary, or move it with the arrow keys: velocities and what the readings call for are found again with it.",
  );
