/**
 * “Download this lesson”, on pages of a web server: the lesson as one file that opens by double click.
 * The site has a shell of it (`sim/pages/single/to_download.py`); what it names is fetched and put in.
 */

import { tr } from "../../view/language.js";
import { say } from "./shared/dom.js";
import { downloadBlob } from "./shared/download.js";

const assets = new URL(".", /** @type {HTMLScriptElement} */ (document.currentScript).src);
const MARK = /<script data-from="([^"]+)"><.script>/;
const place = /** @type {HTMLElement | null} */ (document.querySelector(".carts-download"));

/** @param {URL} address @returns {Promise<string>} */
async function textOf(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(String(answer.status));
  return answer.text();
}

/**
 * @param {URL} shell @param {(done: number, all: number) => void} tell
 * @returns {Promise<Blob>} the whole file
 */
async function whole(shell, tell) {
  const pieces = (await textOf(shell)).split(MARK); // every other one is a name
  let done = 0;
  const parts = await Promise.all(
    pieces.map(async (piece, k) => {
      if (k % 2 === 0) return piece;
      const text = await textOf(new URL(piece, assets));
      done += 1;
      tell(done, (pieces.length - 1) / 2);
      return `<script>${text}</script>`;
    }),
  );
  return new Blob(parts, { type: "text/html" });
}

/** @param {HTMLElement} root */
function offer(root) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "md-button";
  button.textContent = tr("Download this lesson");
  const said = document.createElement("span");
  said.setAttribute("role", "status");
  said.textContent = tr("One file that opens by double click, without a network.");
  const shell = new URL(root.dataset.shell ?? "", document.baseURI);
  button.addEventListener("click", async () => {
    button.disabled = true;
    try {
      const file = await whole(shell, (done, all) =>
        say(said, tr("{done} of {all}", { done, all })),
      );
      const name = location.pathname
        .split("/")
        .pop()
        ?.replace(/(\.html)?$/, ".html");
      downloadBlob(name ?? "lesson.html", file);
      say(said, tr("Saved: {size} MB.", { size: Math.ceil(file.size / 1e6) }));
    } catch {
      say(said, tr("The lesson could not be fetched. Try again with a network."));
    } finally {
      button.disabled = false;
    }
  });
  root.append(button, " ", said);
  root.hidden = false;
}

if (place) offer(place);
