/** The plots of a report as one picture. */

import { svg } from "../shared/dom.js";
import { asPng } from "../shared/picture.js";

const WIDTH = 620;
const GAP = 16;
const LOOKS = [
  "fill",
  "stroke",
  "stroke-width",
  "opacity",
  "font-size",
  "font-family",
  "text-anchor",
];

/** @param {Element} report @returns {Promise<Blob | null>} null: there is no plot */
export async function plotsAsPng(report) {
  const plots = /** @type {SVGSVGElement[]} */ ([...report.querySelectorAll(".carts-class-plot")]);
  if (!plots.length) return null;
  const whole = svg("svg", { xmlns: "http://www.w3.org/2000/svg", width: WIDTH });
  const paper = getComputedStyle(report).getPropertyValue("--carts-paper").trim() || "#fff";
  const sheet = svg("rect", { width: WIDTH, fill: paper });
  whole.append(sheet);
  let y = GAP;
  for (const plot of plots) {
    const copy = /** @type {SVGSVGElement} */ (plot.cloneNode(true));
    const [from, to] = [[...plot.querySelectorAll("*")], [...copy.querySelectorAll("*")]];
    from.forEach((part, k) => {
      const style = getComputedStyle(part);
      for (const look of LOOKS)
        to[k]?.setAttribute(look, style.getPropertyValue(look).replaceAll('"', "'"));
    });
    const { width, height } = plot.viewBox.baseVal;
    for (const [name, value] of Object.entries({ x: 0, y, width, height })) {
      copy.setAttribute(name, String(value));
    }
    whole.append(copy);
    y += height + GAP;
  }
  for (const part of [whole, sheet]) part.setAttribute("height", String(y));
  return asPng(new XMLSerializer().serializeToString(whole));
}
