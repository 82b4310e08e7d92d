/** What is in the model of a scene and what is left out, in the words of a lesson; how it is computed is told elsewhere. */

import { bodiesOf, listed } from "./bodies.js";
import { viewOf } from "./effects.js";
import { phrase } from "./effects-words.js";
import { ended, tr } from "./language.js";
import { APART, capital, lawsOf } from "./words.js";

/** @typedef {import("./types.js").Header} Header */
/** @typedef {import("./types.js").Contact} Contact */

const BOTH_FORCES = tr(
  "Each contact has one force in the program: it acts on both bodies, equally hard, in opposite directions. So the program assumes Newton’s third law; it cannot prove it.",
);

/**
 * @param {Header} header of a run that may be told
 * @param {boolean} numbers false: they would tell a force
 * @returns {string[]} sentences
 */
export function modelSentences(header, numbers) {
  const acting = header.effects.filter(({ active }) => active);
  const sentences = acting.map((effect) => ended(capital(phrase(effect, header, numbers))));
  if (!acting.length) {
    sentences.push(
      tr("Where nothing touches, nothing pushes along the track: every cart keeps its velocity."),
    );
  }
  sentences.push(...contactSentences(header));
  if (header.contacts.some(({ stiffness }) => stiffness)) sentences.push(BOTH_FORCES);
  const leftOut = header.notSimulated.map((kind) => viewOf(kind).name);
  if (leftOut.length) {
    sentences.push(tr("Left out of this model: {effects}.", { effects: listed(leftOut) }));
  }
  return sentences;
}

/**
 * One sentence for each kind of contact; with names where there are several. How lively it is may be what a
 * lesson asks for, and is not told. @param {Header} header
 */
function contactSentences(header) {
  const laws = lawsOf(header);
  /** @type {Map<string, Contact[]>} */
  const alike = new Map();
  for (const contact of header.contacts) {
    if (laws[contact.pair] === APART) continue;
    const key = `${contact.restitution === null} ${contact.stiffness === null}`;
    alike.set(key, [...(alike.get(key) ?? []), contact]);
  }
  return [...alike.values()].map((contacts) => {
    const [one] = contacts;
    const names = contacts.map(({ bodies }) => bodiesOf(bodies, header.track)).join("; ");
    const how = one?.stiffness
      ? tr("bumpers push like springs, the harder the more they are squeezed")
      : one?.restitution === null
        ? tr("whoever touches stays together")
        : tr("a hit takes no time");
    return ended(alike.size > 1 ? `${names}: ${how}` : capital(how));
  });
}
