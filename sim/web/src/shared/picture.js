/** Picture and graphs of a scene as one SVG that stands alone, and as PNG. */

import { svg } from "./dom.js";

const PROPERTIES = [
  "fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "stroke-linejoin",
  "opacity", "visibility", "font-family", "font-size", "font-weight", "font-style", "text-anchor",
  "paint-order", "x", "y", "height",
]; // biome-ignore format: a list
const WIDTH = 720;
const GAP = 12;
const LINE = 20;
const PIXELS = 2; // of the PNG per unit

/** @param {HTMLElement} scene @returns {string} the text of an SVG file */
export function picture(scene) {
  const paper = getComputedStyle(scene).getPropertyValue("--carts-paper") || "#fff";
  const ink = getComputedStyle(scene).color;
  const whole = svg("svg", { xmlns: "http://www.w3.org/2000/svg", width: WIDTH });
  const sheet = svg("rect", { width: WIDTH, fill: paper });
  whole.append(sheet);
  let y = GAP;
  /** @param {string} text @param {number} x @param {number} at @param {string} weight */
  const write = (text, x, at, weight) => {
    const line = svg("text", {
      x,
      y: at,
      fill: ink,
      "font-family": "sans-serif",
      "font-size": 13,
      "font-weight": weight,
    });
    line.textContent = text;
    whole.append(line);
  };
  write(scene.querySelector(".carts-title")?.textContent ?? "", GAP, y + 12, "700");
  y += LINE + 4;
  const stage = [...scene.querySelectorAll(".carts-stage")].find((one) => one.clientWidth);
  if (stage) {
    const drawn = alone(stage);
    const height = place(drawn, 0, y, WIDTH);
    const sky = getComputedStyle(stage.closest(".carts-world") ?? stage).backgroundColor;
    whole.append(svg("rect", { y, width: WIDTH, height, fill: sky }), drawn);
    y += height + GAP;
  }
  const graphs = [...scene.querySelectorAll(".carts-graph")];
  const half = WIDTH / 2;
  for (let k = 0; k < graphs.length; k += 2) {
    let tallest = 0;
    graphs.slice(k, k + 2).forEach((graph, column) => {
      const plot = graph.querySelector(".carts-plot");
      if (!plot) return;
      const x = column * half;
      write(graph.querySelector(".carts-graph-name")?.textContent ?? "", x + GAP, y + 12, "700");
      const drawn = alone(plot);
      const height = place(drawn, x, y + LINE, half - GAP);
      whole.append(drawn);
      const entries = [...graph.querySelectorAll(".carts-key > span")];
      entries.forEach((entry, i) => {
        const at = y + LINE + height + 14 + LINE * i;
        const sample = entry.querySelector("svg");
        if (sample) {
          const swatch = alone(sample);
          place(swatch, x + GAP, at - 10, 26);
          whole.append(swatch);
        }
        write(entry.textContent ?? "", x + GAP + 34, at, "400");
      });
      tallest = Math.max(tallest, LINE + height + LINE * entries.length);
    });
    y += tallest + GAP;
  }
  for (const part of [whole, sheet]) part.setAttribute("height", String(Math.ceil(y)));
  whole.setAttribute("viewBox", `0 0 ${WIDTH} ${Math.ceil(y)}`);
  return new XMLSerializer().serializeToString(whole);
}

/** A copy that carries its looks with it. @param {Element} original @returns {Element} */
function alone(original) {
  const copy = /** @type {Element} */ (original.cloneNode(true));
  const [from, to] = [
    [original, ...original.querySelectorAll("*")],
    [copy, ...copy.querySelectorAll("*")],
  ];
  from.forEach((part, i) => {
    const style = getComputedStyle(part);
    const made = /** @type {Element} */ (to[i]);
    if (style.display === "none" && part.closest("defs") === null)
      made.setAttribute("display", "none");
    for (const property of PROPERTIES) {
      const value = style.getPropertyValue(property);
      const geometry = ["x", "y", "height"].includes(property);
      if (geometry && (part.tagName !== "rect" || made.hasAttribute(property))) continue;
      if (value && value !== "auto") made.setAttribute(property, value.replaceAll('"', "'"));
    }
    made.removeAttribute("class");
  });
  return copy;
}

/** @param {Element} drawn @param {number} x @param {number} y @param {number} width @returns {number} its height */
function place(drawn, x, y, width) {
  const [, , w = 1, h = 1] = (drawn.getAttribute("viewBox") ?? "0 0 1 1").split(" ").map(Number);
  const height = (width * h) / w;
  for (const [name, value] of Object.entries({ x, y, width, height })) {
    drawn.setAttribute(name, String(value));
  }
  return height;
}

/** @param {string} text of an SVG file @returns {Promise<Blob>} */
export async function asPng(text) {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = image.naturalWidth * PIXELS;
  canvas.height = image.naturalHeight * PIXELS;
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error("no picture was made"))),
      "image/png",
    );
  });
}
