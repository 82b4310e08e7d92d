/**
 * What is known of effects here comes from their folders: `sim/effects/<kind>/view.js`. An effect
 * without one is drawn as a force, with the name and the agent that its run tells; one that nobody
 * describes is a fault of the program.
 */

import { VIEWS } from "../effects/views.js";
import { told } from "./language.js";

/** @typedef {import("./types.js").Header} Header */
/** @typedef {import("./types.js").Effect} Effect */
/** @typedef {import("./types.js").EffectView} EffectView */

const LAST = 100; // row of the arrow of an effect that does not say where it stands

/** @param {string} kind @returns {Required<Pick<EffectView, "name" | "row">> & EffectView} */
export function viewOf(kind) {
  return { name: kind, row: LAST, ...VIEWS[kind] };
}

/** @param {Effect} effect @returns {string} it as a list names it */
export function nameOf({ kind, called }) {
  const name = VIEWS[kind]?.name ?? (called && told(called));
  if (!name) throw new Error(`nobody describes an effect of the kind “${kind}”`);
  return name;
}

/** @param {Effect} effect @returns {string} who or what its force comes from */
export function agent(effect) {
  const named = effect.by || effect.agent;
  return viewOf(effect.kind).agent?.(effect) ?? (named ? told(named) : nameOf(effect));
}

/** @param {Effect} effect @param {number} t in s @returns {boolean} whether it acts then */
export function actsAt(effect, t) {
  return effect.active && (viewOf(effect.kind).acts?.(effect, t) ?? true);
}

/** @param {Header} header @returns {string[]} kinds that act on single carts, as their arrows stand from above to below */
export function kindsOnOne({ effects }) {
  const kinds = new Set(effects.filter(({ between }) => !between).map(({ kind }) => kind));
  return [...kinds].sort((a, b) => viewOf(a).row - viewOf(b).row || (a < b ? -1 : 1));
}

/** @param {Effect} effect @returns {boolean} whether two bodies push or pull each other by it without touching */
export function isLink(effect) {
  const { link, lasts } = viewOf(effect.kind);
  return effect.between !== null && link !== null && (lasts?.(effect) ?? true);
}

/** @param {Header} header @returns {Set<string>} pairs, such as A-B, that can push or pull each other without touching */
export function linkedPairs({ effects }) {
  return new Set(effects.filter(isLink).map(({ between }) => String(between?.join("-"))));
}

/** @param {Header} header @returns {string[][]} pairs that push each other across the room between them */
export function pairsApart({ effects }) {
  return effects.flatMap(({ kind, active, between }) =>
    active && between && viewOf(kind).apart ? [between] : [],
  );
}

/** @param {Header} header @param {string} pair @returns {string} what acts between the two now, as a label names it; "" where nothing does */
export function linkOf({ effects }, pair) {
  const link = effects.find(
    (effect) => effect.active && isLink(effect) && effect.between?.join("-") === pair,
  );
  return link ? (viewOf(link.kind).link ?? viewOf(link.kind).name) : "";
}

/** @param {string} target such as friction.active or effects.1.force @param {Header} header @returns {Effect | undefined} */
export function effectOf(target, { effects }) {
  const owner = target.slice(0, target.lastIndexOf("."));
  return effects.find(({ kind, index }) =>
    [kind, `effects.${index}`, `effects.${index}.${kind}`].includes(owner),
  );
}
