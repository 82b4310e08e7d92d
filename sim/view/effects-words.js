/** What acts in a scene, in words. */

import { bodiesOf, listed } from "./bodies.js";
import { agent, isLink, nameOf, viewOf } from "./effects.js";
import { inRow, tr } from "./language.js";

/** @typedef {import("./types.js").Header} Header */
/** @typedef {import("./types.js").Effect} Effect */

/** @param {Header} header @param {boolean} numbers false: they would tell a force @returns {string} in and out of the model */
export function actingSentences(header, numbers) {
  if (!header.effects.length) return "";
  const acting = header.effects
    .filter(({ active }) => active)
    .map((effect) => phrase(effect, header, numbers));
  const inside = acting.length
    ? acting.join("; ")
    : tr("nothing but the contacts between the carts");
  const leftOut = header.notSimulated.map((kind) => viewOf(kind).leftOut ?? viewOf(kind).name);
  const model = tr("In this model: {effects}.", { effects: inside });
  if (!leftOut.length) return model;
  const outside = tr("Left out: {effects}.", { effects: inRow(leftOut) });
  return `${model} ${outside}`;
}

/** @param {Effect} effect @param {Header} header @param {boolean} numbers */
export function phrase(effect, header, numbers) {
  const { kind, carts, between } = effect;
  const view = viewOf(kind);
  const told = {
    everyone: carts.length === header.bodies.length,
    on: listed(carts),
    both: bodiesOf(between ?? carts, header.track),
    agent: agent(effect),
    seen: (/** @type {string} */ text) => (numbers ? text : ""),
  };
  const parts = view.phrase?.(effect, told) ?? [nameOf(effect)];
  return parts.filter(Boolean).join(", ");
}

/** @param {Header} header @returns {string} what the graph of F shows, with its sign */
export function forceName({ effects }) {
  return effects.some(isLink) ? tr("Force between them") : tr("Contact force");
}

/** @param {Header} header @returns {string} what the graph of F shows, without a sign */
export function sizeName({ effects }) {
  return effects.some(isLink)
    ? tr("Size of the force between them")
    : tr("Size of the contact force");
}

/**
 * When effects begin and end, with what to say; these are no events of the run itself.
 * @param {Header} header @param {boolean} forces whether they may be told @returns {{t: number, sentence: string}[]}
 */
export function marks({ effects, until }, forces) {
  return effects
    .filter(({ active }) => active)
    .flatMap((effect) => viewOf(effect.kind).marks?.(effect, agent(effect), until, forces) ?? []);
}
