/**
 * “Download this lesson”, on pages of a web server: the lesson as one file that opens by double click.
 * The site has a shell of it (`sim/pages/single/to_download.py`); what it names is fetched and put in.
 */

import { tr } from "../../../view/language.js";
import { Line, persistently } from "../runtime/line.js";
import { say } from "../shared/dom.js";
import { downloadBlob } from "../shared/download.js";

const MARK = /<script data-from="([^"]+)"><.script>/;

/**
 * As the server has it now: the shell names its scripts by their hashes, and one that a browser kept from
 * an earlier version would not run in it. @param {URL} address @returns {Promise<string>}
 */
const textOf = (address) =>
  persistently(async () => {
    const answer = await fetch(address, { cache: "no-cache" });
    if (!answer.ok) throw new Error(String(answer.status));
    return answer.text();
  });

/**
 * @param {URL} shell @param {string} assets address of the folder of scripts @param {(done: number, all: number) => void} tell
 * @returns {Promise<Blob>} the whole file
 */
async function whole(shell, assets, tell) {
  const pieces = (await textOf(shell)).split(MARK); // every other one is a name
  const line = new Line(); // some 15 MB: a slow network that is asked for all at once finishes nothing
  let done = 0;
  const parts = await Promise.all(
    pieces.map(async (piece, k) => {
      if (k % 2 === 0) return piece;
      const text = await line.take(() => textOf(new URL(piece, assets)));
      done += 1;
      tell(done, (pieces.length - 1) / 2);
      return `<script>${text}</script>`;
    }),
  );
  return new Blob(parts, { type: "text/html" });
}

/**
 * A button and what it says. @param {string} address of the shell @param {string} assets address of the folder of scripts
 * @returns {HTMLElement}
 */
export function downloadLine(address, assets) {
  const line = document.createElement("p");
  const button = document.createElement("button");
  button.type = "button";
  button.className = "md-button";
  button.textContent = tr("Download this lesson");
  const said = document.createElement("span");
  said.setAttribute("role", "status");
  said.textContent = tr("One file that opens by double click, without a network.");
  const shell = new URL(address, document.baseURI);
  button.addEventListener("click", async () => {
    button.disabled = true;
    try {
      const file = await whole(shell, assets, (done, all) =>
        say(said, tr("{done} of {all}", { done, all })),
      );
      const name = decodeURIComponent(location.pathname).split("/").filter(Boolean).pop();
      downloadBlob((name ?? "lesson").replace(/(\.html)?$/, ".html"), file);
      say(said, tr("Saved: {size} MB.", { size: Math.ceil(file.size / 1e6) }));
    } catch {
      say(said, tr("The lesson could not be fetched. Try again with a network."));
    } finally {
      button.disabled = false;
    }
  });
  line.append(button, " ", said);
  return line;
}
