/** Buttons, speed, clocks and keys: everything that moves the time. */

import { tr } from "../../../../view/language.js";
import { fixed } from "../../../../view/numbers.js";
import { need, say } from "../../shared/dom.js";
import { rateText } from "./slow.js";

/** @typedef {import("./player.js").Player} Player */

export class Transport {
  /** @param {HTMLElement} root @param {Player} player @param {Record<string, number>} decimals */
  constructor(root, player, decimals) {
    this.player = player;
    this.decimals = decimals;
    this.bar = need(root, ".carts-transport");
    this.world = need(root, ".carts-world");
    this.play = need(root, ".carts-play");
    this.playText = need(this.play, "span");
    this.clock = need(root, ".carts-clock");
    this.ownClock = root.querySelector(".carts-own-clock");
    this.rate = root.querySelector(".carts-rate");
    this.scrub = need(root, ".carts-scrub");
    const click = (/** @type {string} */ selector, /** @type {() => void} */ act) =>
      need(root, selector).addEventListener("click", act);
    click(".carts-start", () => {
      player.pause();
      player.seek(0);
    });
    click(".carts-back", () => player.step(-1));
    click(".carts-play", () => player.toggle());
    click(".carts-forward", () => player.step(1));
    const speed = /** @type {HTMLSelectElement} */ (need(root, ".carts-speed"));
    player.speed = Number(speed.value);
    speed.addEventListener("change", () => {
      player.speed = Number(speed.value);
      player.changed(player.time, false);
    });
    const slow = /** @type {HTMLInputElement | null} */ (root.querySelector(".carts-slow"));
    player.slow = slow?.checked ?? false;
    slow?.addEventListener("change", () => {
      player.slow = slow.checked;
      player.changed(player.time, false);
    });
    this.world.addEventListener("keydown", (event) => {
      if (event.target === this.world) this.#key(event);
    });
    this.scrub.addEventListener("keydown", (event) => this.#key(event));
    this.scrub.addEventListener("pointerdown", () => player.pause());
  }

  /** Shows the time and the state of the player. */
  show() {
    const { player } = this;
    say(this.clock, fixed(player.time, player.isSlow ? 4 : (this.decimals.t ?? 3)));
    say(this.playText, this.#name());
    this.bar.classList.toggle("carts-is-playing", player.playing);
    this.bar.classList.toggle("carts-is-slow", player.isSlow);
    this.world.classList.toggle("carts-is-slow", player.isSlow);
    if (this.rate) say(this.rate, rateText(player.rate));
    if (this.ownClock) say(this.ownClock, fixed(player.own, 1));
  }

  #name() {
    if (this.player.playing) return tr("Pause");
    return this.player.time >= this.player.until ? tr("Again") : tr("Play");
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const act = {
      " ": () => event.repeat || this.player.toggle(),
      ArrowLeft: () => this.player.step(-1),
      ArrowDown: () => this.player.step(-1),
      ArrowRight: () => this.player.step(1),
      ArrowUp: () => this.player.step(1),
      PageDown: () => this.player.step(-1, 10),
      PageUp: () => this.player.step(1, 10),
      Home: () => this.player.seek(0),
      End: () => this.player.seek(this.player.until),
    }[event.key];
    if (!act || /** @type {HTMLInputElement} */ (this.scrub).disabled) return;
    event.preventDefault();
    act();
  }
}
