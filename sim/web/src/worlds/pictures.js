/**
 * Pictures with one clock: the run as it is, and the same start in a world that does not exist; or a
 * run alone. What is impossible says so in the picture itself, so that no copy of it goes without.
 */

import { tr } from "../../../view/language.js";
import { fixed } from "../../../view/numbers.js";
import { stage } from "../../../view/skeleton/stage.js";
import { windowsOf } from "../../../view/windows.js";
import { Stage } from "../scene/stage.js";
import { Player } from "../scene/time/player.js";
import { slowParts } from "../scene/time/slow.js";
import { html, say, svg } from "../shared/dom.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("../../../view/types.js").Baked} Baked */

const SIGN = 60; // units that the sign stands above the track

/** @typedef {{run: Run, caption: string, impossible?: boolean}} Shown */

export class Pictures {
  /** @param {Baked} baked @param {Shown[]} shown */
  constructor(baked, shown) {
    this.root = html("div", "carts-worlds-pictures");
    this.decimals = baked.view.decimals.t ?? 2;
    this.player = new Player(() => this.#at());
    const all = shown.map(({ run }) => windowsOf(run));
    this.player.until = Math.max(...shown.map(({ run }) => run.header.until));
    this.player.parts = slowParts(all.flat().sort((a, b) => a.start - b.start));
    /** @type {Stage[]} */
    this.stages = [];
    for (const [k, one] of shown.entries()) this.#picture(baked, one, all[k] ?? []);
    this.root.append(this.#bar());
    this.#at();
  }

  /** Nothing moves any more. */
  leave() {
    this.player.pause();
  }

  /**
   * @param {Baked} baked @param {Shown} shown
   * @param {import("../../../view/windows.js").Touch[]} windows
   */
  #picture(baked, { run, caption, impossible = false }, windows) {
    const figure = html("figure", impossible ? "carts-impossible" : "");
    const own = { ...baked, run, fence: { ...baked.fence, id: `${baked.fence.id}-other` } };
    const template = document.createElement("template");
    template.innerHTML = baked.view.layouts.map((layout) => stage(own, layout)).join("");
    const label = html("figcaption", "", caption);
    if (impossible) label.prepend(html("b", "", tr("Impossible:")), " ");
    figure.append(label, template.content);
    for (const root of figure.querySelectorAll("svg")) {
      const made = new Stage(root, baked);
      made.show(run, windows);
      this.stages.push(made);
      if (!impossible) continue;
      const { width, track } = made.layout;
      const place = { x: width / 2, y: track - SIGN, "text-anchor": "middle" };
      const text = svg("text", { class: "carts-impossible-sign", ...place });
      text.textContent = tr("impossible");
      root.prepend(text);
    }
    this.root.append(figure);
  }

  #bar() {
    const bar = html("div", "carts-worlds-bar");
    this.play = html("button", "carts-button carts-play", "");
    this.play.setAttribute("type", "button");
    this.play.addEventListener("click", () => this.player.toggle());
    this.scrub = document.createElement("input");
    Object.assign(this.scrub, { type: "range", min: "0", max: String(this.player.until) });
    this.scrub.step = String(this.player.until / 1000);
    this.scrub.setAttribute(
      "aria-label",
      this.stages.length > 2 ? tr("Time in both pictures") : tr("Time"),
    );
    this.scrub.addEventListener("input", () => {
      this.player.pause();
      this.player.seek(Number(this.scrub?.value));
    });
    this.clock = html("span", "carts-worlds-clock");
    bar.append(this.play, this.scrub, this.clock);
    return bar;
  }

  #at() {
    const t = this.player.time;
    for (const one of this.stages) one.at(t);
    if (!this.scrub || !this.clock || !this.play) return;
    this.scrub.value = String(t);
    const words = tr("{time} s", { time: fixed(t, 2) });
    this.scrub.setAttribute("aria-valuetext", words);
    say(this.clock, words);
    this.play.classList.toggle("carts-is-playing", this.player.playing);
    say(this.play, this.player.playing ? tr("Pause") : tr("Play"));
  }
}
