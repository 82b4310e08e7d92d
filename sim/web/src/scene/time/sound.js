/**
 * A click for each contact, as loud as its greatest force: off until a reader switches it on, then for
 * as long as the tab is open. Made here: no file is loaded, and no sound machine before it is wanted.
 */

import { recall, retain } from "../../shared/tab.js";

/** @typedef {import("../../../../view/types.js").RunEvent} RunEvent */

const KEY = "carts-sound";
const LASTS = 0.08; // s
const FADES = 60; // 1/s
const SOFTEST = 0.05; // of the loudest: a contact that is heard at all

let wanted = recall(KEY) === true; // in all scenes of the page

/** @type {AudioContext | null} of all scenes: a browser has few */
let made = null;

export class Sound {
  get on() {
    return wanted;
  }

  /** @param {boolean} on by the reader */
  set(on) {
    wanted = on;
    retain(KEY, on);
    for (const box of document.querySelectorAll('[data-choice="sound"]')) {
      /** @type {HTMLInputElement} */ (box).checked = on;
    }
    if (on) this.#click(SOFTEST); // a first one: it works, and this is how loud it is at least
  }

  /** What happened in a piece of the run. @param {RunEvent[]} events of the run @param {number} before @param {number} now both in s */
  between(events, before, now) {
    if (!this.on) return;
    const after = before || -1; // what happens at the start is heard, too
    const loudest = Math.max(...events.map(strength));
    for (const event of events) {
      const part = strength(event) / loudest;
      if (event.t > after && event.t <= now && part > 0) this.#click(Math.max(part, SOFTEST));
    }
  }

  /** @param {number} loud 0 to 1 */
  #click(loud) {
    try {
      made ??= new AudioContext();
      const machine = made;
      void machine.resume(); // it may begin only after a reader has pressed something
      const noise = machine.createBuffer(1, machine.sampleRate * LASTS, machine.sampleRate);
      const samples = noise.getChannelData(0);
      samples.forEach((_, k) => {
        const t = k / machine.sampleRate;
        samples[k] = loud * Math.exp(-FADES * t) * (2 * Math.random() - 1);
      });
      const source = machine.createBufferSource();
      source.buffer = noise;
      source.connect(machine.destination);
      source.start();
    } catch {
      this.set(false); // no loudspeaker: the run goes on in silence
    }
  }
}

/** N at the greatest squeeze, or N s of a contact without duration; 0 of what makes no sound. @param {RunEvent} event */
function strength({ kind, force, impulse }) {
  if (kind === "peak") return force ?? 0;
  return kind === "contact" || kind === "release" ? (impulse ?? 0) : 0;
}
