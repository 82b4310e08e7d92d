/**
 * A state of a scene as text: a link that brings it back, and a block for a lesson. What a link asks
 * for is checked like any other input: by Python, when it is set.
 */

import { tr } from "../../../../view/language.js";
import { effectPath } from "../switches.js";

/** @typedef {Record<string, number | string | boolean>} Settings */

const MARK = "carts:";
const MOST_KEYS = 60;
const LONGEST = 4000;
const LONGEST_VALUE = 40;
const TARGET = /^[A-Za-z][\w-]*(\.[\w-]+){0,3}$/;

/** @param {string} id of the scene @param {Settings} settings @param {number} t in s @returns {string} what comes after # */
export function linkTo(id, settings, t) {
  const parts = Object.entries({ ...settings, t: Number(t.toPrecision(6)) });
  return `${MARK}${id}?${parts.map(([key, value]) => `${key}=${encodeURIComponent(value)}`).join("&")}`;
}

/**
 * What a link asks this scene for; null: it is not about this scene.
 * @param {string} hash with or without its # @param {string} id
 * @returns {{settings: Settings, t: number} | {problem: string} | null}
 */
export function readLink(hash, id) {
  const text = hash.replace(/^#/, "");
  if (!text.startsWith(`${MARK}${id}?`)) return null;
  if (text.length > LONGEST) return { problem: tr("This link is too long: it was not used.") };
  /** @type {Settings} */
  const settings = {};
  let t = 0;
  const parts = text.slice(MARK.length + id.length + 1).split("&");
  for (const part of parts.filter(Boolean).slice(0, MOST_KEYS)) {
    const [key = "", value = ""] = [part.split("=")[0], decoded(part.slice(part.indexOf("=") + 1))];
    if (!TARGET.test(key) || !value || value.length > LONGEST_VALUE) {
      return { problem: tr("This link is damaged: it was not used.") };
    }
    if (key === "t") t = Number(value);
    else if (/^(true|false)$/.test(value)) settings[key] = value === "true";
    else settings[key] = Number.isFinite(Number(value)) ? Number(value) : value;
  }
  return { settings, t: Number.isFinite(t) ? Math.max(0, t) : 0 };
}

/**
 * Brings back the state that the page's address asks for.
 * @param {HTMLElement & {time: number}} scene @param {{become: (settings: Settings) => Promise<void>}} runs
 * @param {(message: string) => void} say
 */
export async function followLink(scene, runs, say) {
  const asked = readLink(location.hash, scene.id);
  if (!asked) return;
  if ("problem" in asked) return say(asked.problem);
  try {
    await runs.become(asked.settings); // what a link does not name is as the lesson has it
    scene.time = asked.t;
    scene.scrollIntoView();
  } catch (error) {
    const { message } = /** @type {Error} */ (error);
    say(tr("This link does not fit this scene: {why}", { why: message }));
  }
}

/** @param {string} text */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return "";
  }
}

/**
 * A block for a lesson that starts as the scene stands now.
 * @param {import("../../../../view/types.js").Fence} fence @param {Settings} settings @returns {string} YAML between fences
 */
export function sceneBlock(fence, settings) {
  const scene = structuredClone(fence.scene);
  for (const [target, value] of Object.entries(settings)) change(scene, target, value);
  const lines = [`id: ${fence.id}-copy`];
  for (const [key, value] of Object.entries(scene)) {
    if (key === "carts") {
      lines.push("carts:");
      for (const [name, cart] of Object.entries(/** @type {object} */ (value))) {
        lines.push(`  ${name}: ${flow(cart)}`);
      }
    } else lines.push(`${key}: ${flow(value)}`);
  }
  lines.push(`show: ${flow(fence.show)}`);
  if (fence.opened?.length) lines.push(`with: ${flow(fence.opened)}`);
  if (fence.watch === "free") lines.push("watch: free");
  if (fence.slow !== "auto") lines.push(`slow: ${fence.slow}`);
  if (fence.boxes === "alike") lines.push(`boxes: ${fence.boxes}`);
  if (fence.forces !== "shown") lines.push(`forces: ${fence.forces}`);
  if (fence.camera) lines.push(`view: moving ${fence.camera} m/s`);
  const switches = fence.switches ?? [];
  if (fence.controls.length || switches.length) lines.push("controls:");
  for (const { set, low, high, step, unit } of fence.controls) {
    const part = (/** @type {number} */ value) => `${value} ${unit}`.trim();
    lines.push(`  - {set: ${set}, from: ${part(low)}, to: ${part(high)}, step: ${part(step)}}`);
  }
  for (const { set } of switches) lines.push(`  - {switch: ${set.replace(/\.active$/, "")}}`);
  const presets = Object.entries(fence.presets ?? {});
  if (presets.length) lines.push("presets:");
  for (const [name, values] of presets) lines.push(`  ${JSON.stringify(name)}: ${flow(values)}`);
  return `\`\`\`scene\n${lines.join("\n")}\n\`\`\`\n`;
}

/** @param {Record<string, any>} scene @param {string} target @param {number | string | boolean} value */
function change(scene, target, value) {
  const keys = target.split(".");
  const path = scene.carts?.[String(keys[0])]
    ? ["carts", ...keys]
    : (effectPath(scene, keys) ?? keys);
  let place = scene;
  for (const key of path.slice(0, -1)) {
    place[key] ??= {};
    place = place[key];
  }
  place[String(path.at(-1))] = value;
}

/** @param {unknown} value @returns {string} YAML on one line */
function flow(value) {
  if (Array.isArray(value)) return `[${value.map(flow).join(", ")}]`;
  if (value && typeof value === "object") {
    return `{${Object.entries(value)
      .map(([key, item]) => `${key}: ${flow(item)}`)
      .join(", ")}}`;
  }
  if (typeof value !== "string") return String(value);
  return /^[A-Za-z0-9.+−-][\w .+/·²³^-]*$/.test(value) &&
    !/^(no|yes|on|off|true|false|null)$/i.test(value)
    ? value
    : JSON.stringify(value);
}
