/** Sentences for readers. Twin of `sim/pages/widget/words.py`. */

import { fixed, short, speedUnit } from "./numbers.js";

/** @typedef {import("./types.js").RunEvent} RunEvent */
/** @typedef {import("./types.js").Header} Header */
/** @typedef {{decimals: Record<string, number>, scale: number, camera: number, forces: boolean}} Telling */
/** @typedef {Record<string, string>} Laws the law of each pair, by its name such as A-B */

/** @type {Record<string, [string, string, string]>} title, symbol, unit */
export const QUANTITIES = {
  x: ["Position", "x", "m"],
  v: ["Velocity", "v", "m/s"],
  a: ["Acceleration", "a", "m/s²"],
  F: ["Contact force", "F", "N"],
  p: ["Momentum", "p", "kg m/s"],
  energy: ["Kinetic energy", "E", "J"],
};
/** @type {Record<string, string>} */
export const EFFECTS = {
  friction: "friction",
  incline: "a slope",
  drag: "air resistance",
  push: "pushes from outside",
  spring: "springs between the carts",
  magnets: "magnets",
  release: "a release between the carts",
};
const BOTH_FORCES =
  "Each contact has one force in the program: it pushes both bodies, equally hard, " +
  "away from each other. So the program assumes Newton’s third law; it cannot prove it.";
const IMPULSE_ONLY = "too large and too short to draw: see the impulses under “What happens”";
const JUMP_ONLY = "where v jumps, the acceleration is too large and too short to draw";

/** @param {string} name */
export function isWall(name) {
  return name === "left" || name === "right";
}

/** @param {string} name @returns {string} a body as a sentence names it */
export function body(name) {
  return isWall(name) ? `the ${name} wall` : name;
}

/** @param {string} name @returns {string} a body as a label names it */
export function brief(name) {
  return isWall(name) ? `${name} wall` : name;
}

/** @param {number} velocity @param {number} decimals @param {number} scale of velocities in the scene */
export function motion(velocity, decimals, scale) {
  if (Math.abs(velocity) < 1e-9 * scale) return "at rest";
  const [per, unit] = speedUnit(scale);
  const speed = `${fixed(Math.abs(velocity) / per, decimals)}\u00a0${unit}`;
  return `${speed} to the ${velocity > 0 ? "right" : "left"}`;
}

/** @param {Header["contacts"]} contacts @returns {Laws} */
export function lawsOf(contacts) {
  return Object.fromEntries(contacts.map(({ pair, law }) => [pair, law]));
}

/** @param {RunEvent} event @param {Telling} telling @param {Laws} laws @returns {string} what happens at an event */
export function eventSentence(event, telling, laws) {
  const { decimals, scale, camera, forces } = telling;
  const names = event.bodies;
  const pair = capital(names.map(body).join(" and "));
  const impulse = event.impulse ?? 0;
  const speeds = names
    .filter((name) => !isWall(name) && name in (event.after ?? {}))
    .map((name) => `${name}: ${motion((event.after[name] ?? 0) - camera, decimals.v ?? 2, scale)}`);
  const after = speeds.length ? ` ${speeds.join(". ")}.` : "";
  const shown = forces && impulse ? ` Impulse on each: ${short(impulse)}\u00a0N\u00a0s.` : "";
  switch (event.kind) {
    case "contact": {
      if (impulse && laws[names.join("-")] === "velcro") {
        return `${pair} hit and stay together.${shown}${after}`;
      }
      if (impulse && joined(event, scale)) {
        return `${pair} hit and ${goOn(event, telling)}.${shown}`;
      }
      if (impulse) return `${pair} hit each other and part at once.${shown}${after}`;
      const [mover, other] = names[0] === "left" ? [names[1], names[0]] : [names[0], names[1]];
      return `${mover} reaches ${body(String(other))}.`;
    }
    case "peak":
      if (forces && event.force) {
        const size = fixed(event.force, decimals.F ?? 2);
        return `${pair}: bumpers squeezed the most, ${size}\u00a0N on each.`;
      }
      return `${pair}: bumpers squeezed the most.`;
    case "separate":
      if (joined(event, scale)) {
        const who = names.map(body).join(" and ");
        const rest = isWall(String(names[0])) || isWall(String(names.at(-1)));
        const left = rest ? "they stay together" : `they ${goOn(event, telling)}`;
        return `The push between ${who} has ended; ${left}.${shown}${rest ? after : ""}`;
      }
      return `${pair} separate.${shown}${after}`;
    case "stick":
      return `${pair} stay together.${after}`;
    case "stop":
      return names[1]
        ? `${pair} stop: the track holds them.`
        : `${pair} stops: the track holds it.`;
    case "start":
      return `${pair} ${names[1] ? "start" : "starts"} to slide.`;
    case "release":
      return `The exploder between ${pair} releases.${shown}${after}`;
    case "end":
      return "End of the run.";
    default:
      return `${event.kind}: ${pair}.`;
  }
}

/** Whether both bodies have one velocity after the event; a wall has none. @param {RunEvent} event @param {number} scale */
function joined({ bodies, after }, scale) {
  const [left, right] = bodies.map((name) => (isWall(name) ? 0 : Number(after[name])));
  return Math.abs(Number(left) - Number(right)) < 1e-9 * scale; // rounding, not motion
}

/** @param {RunEvent} event of two bodies with one velocity @param {Telling} telling */
function goOn({ bodies, after }, { decimals, scale, camera }) {
  const cart = bodies.find((name) => !isWall(name)) ?? "";
  const seen = motion(Number(after[cart]) - camera, decimals.v ?? 2, scale);
  return seen === "at rest" ? "stay together, at rest" : `go on together at ${seen}`;
}

/** @param {import("./exits.js").Exit} exit @param {number} decimals @param {number} scale @returns {string} */
export function exitSentence({ name, side, velocity }, decimals, scale) {
  const [per, unit] = speedUnit(scale);
  const speed = `${fixed(Math.abs(velocity) / per, decimals)}\u00a0${unit}`;
  return `${name} leaves the picture on the ${side}, still ${speed}.`;
}

/**
 * What a graph cannot show of a run, or why it is empty; "" where there is nothing to say.
 * @param {string} quantity @param {RunEvent[]} events @param {number} curves that are drawn
 */
export function graphNote(quantity, events, curves) {
  const struck = events.some((event) => event.kind === "contact" && event.impulse);
  if (struck && quantity === "F") return IMPULSE_ONLY;
  if (struck && quantity === "a") return JUMP_ONLY;
  return quantity === "F" && !curves ? "no contact force in this run" : "";
}

/** @param {Header} header @returns {string[]} what is in this model, and what is left out */
export function modelSentences(header) {
  const sentences = [...new Set(header.plan.map((phase) => sentence(phase.why)))];
  const told = header.plan.length > 0; // not so before a prediction
  if (told && header.contacts.some((contact) => contact.stiffness)) sentences.push(BOTH_FORCES);
  const leftOut = header.notSimulated.map((name) => EFFECTS[name] ?? name);
  const last = leftOut.pop();
  if (last !== undefined) {
    const listed = leftOut.length ? `${leftOut.join(", ")} and ${last}` : last;
    sentences.push(`Left out of this model: ${listed}.`);
  }
  return sentences;
}

/** @param {string} text */
function capital(text) {
  return text.slice(0, 1).toUpperCase() + text.slice(1);
}

/** @param {string} text */
function sentence(text) {
  const capitalised = capital(text);
  return /[.!?]$/.test(capitalised) ? capitalised : `${capitalised}.`;
}
