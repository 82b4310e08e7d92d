/** Films of carts: known by their name, read by a script of their own that comes only when one is chosen. */

import { tr } from "../../../view/language.js";
import { bring } from "../shared/bring.js";
import { need } from "../shared/dom.js";

/** @typedef {{at: (time: number, places: Record<string, number>) => void, end: () => void}} Session */
/** @typedef {"" | "carts" | "clock"} Same what these readings have in common with those before */
/** @typedef {(name: string, texts: string[], same?: Same) => void} Take what was read */
/** @typedef {(text: string) => void} Tell */
/**
 * @typedef {{open: (bench: HTMLElement, file: File, take: Take) => Session,
 *   camera: (bench: HTMLElement, take: (file: File) => void, tell: Tell) => Promise<() => void>}} Script
 */

const NAMED = /\.(mp4|m4v|mov|qt|webm|mkv|avi|3gp)$/i;
const SCRIPT = "film.js"; // beside the script of this page

/** @param {File} file */
export const isFilm = ({ name, type }) => type.startsWith("video/") || NAMED.test(name);

export class Films {
  /** @type {Session | null} */
  #session = null;
  #filmed = () => {}; // ends the camera
  #turn = 0; // what is waited for counts only while nothing newer is wanted

  /**
   * @param {HTMLElement} bench @param {string} base address of the page's script
   * @param {Take} take @param {Tell} tell
   */
  constructor(bench, base, take, tell) {
    this.bench = bench;
    this.base = base;
    this.take = take;
    this.tell = tell;
    const input = /** @type {HTMLInputElement} */ (need(bench, ".carts-measured-film-file"));
    need(bench, ".carts-measured-film").addEventListener("click", () => input.click());
    input.addEventListener("change", () => {
      const [file] = input.files ?? [];
      if (file) void this.open(file);
      input.value = "";
    });
    const camera = need(bench, ".carts-measured-camera");
    camera.hidden = !mayFilm();
    camera.addEventListener("click", () => void this.camera());
  }

  /** @returns {Promise<Script | null>} after what was shown before is gone; null: something newer is wanted, or there is none */
  async #script() {
    this.end();
    const turn = this.#turn;
    const { search } = new URL(this.base);
    const address = new URL(SCRIPT + search, this.base).href;
    /** @type {Script | null} */
    const script = await bring("cartsFilm", address);
    if (turn !== this.#turn) return null;
    this.tell(script ? "" : tr("What reads films is missing: this page was not copied whole."));
    return script;
  }

  /** @param {File} file */
  async open(file) {
    const script = await this.#script();
    this.#session = script?.open(this.bench, file, this.take) ?? null;
  }

  /** Films with the camera of this computer. */
  async camera() {
    const script = await this.#script();
    if (!script) return;
    const turn = this.#turn;
    const end = await script.camera(this.bench, (file) => void this.open(file), this.tell);
    if (turn === this.#turn) this.#filmed = end;
    else end(); // the reader was asked, and chose a file instead or pressed twice
  }

  /** Shows the film where the model is. @param {number} time s @param {Record<string, number>} places m, by cart */
  at(time, places) {
    this.#session?.at(time, places);
  }

  /** Other readings are shown now. */
  end() {
    this.#turn += 1;
    this.#session?.end();
    this.#session = null;
    this.#filmed();
    this.#filmed = () => {};
  }
}

/** Only pages that came by https may use a camera; a phone offers its own where a film is chosen. */
function mayFilm() {
  const hosted = location.protocol.startsWith("http") && isSecureContext;
  return hosted && Boolean(navigator.mediaDevices) && typeof MediaRecorder === "function";
}
