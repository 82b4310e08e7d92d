"use strict";
(() => {
  // ../view/language.js
  var catalogue = (
    /** @type {any} */
    globalThis.cartsWords ?? {}
  );
  function tr(sentence, values = {}) {
    return filled(catalogue[sentence] ?? sentence, values);
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole2, name) => String(values[name] ?? whole2));
  }

  // src/shared/dom.js
  function say(element, text) {
    if (element.textContent !== text) element.textContent = text;
  }

  // src/shared/download.js
  var FORGOTTEN_AFTER = 6e4;
  function downloadBlob(name, blob) {
    const link = document.createElement("a");
    const address = URL.createObjectURL(blob);
    link.href = address;
    link.download = name;
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), FORGOTTEN_AFTER);
  }

  // src/download-main.js
  var assets = new URL(
    ".",
    /** @type {HTMLScriptElement} */
    document.currentScript.src
  );
  var MARK = /<script data-from="([^"]+)"><.script>/;
  var place = (
    /** @type {HTMLElement | null} */
    document.querySelector(".carts-download")
  );
  async function textOf(address) {
    const answer = await fetch(address);
    if (!answer.ok) throw new Error(String(answer.status));
    return answer.text();
  }
  async function whole(shell, tell) {
    const pieces = (await textOf(shell)).split(MARK);
    let done = 0;
    const parts = await Promise.all(
      pieces.map(async (piece, k) => {
        if (k % 2 === 0) return piece;
        const text = await textOf(new URL(piece, assets));
        done += 1;
        tell(done, (pieces.length - 1) / 2);
        return `<script>${text}<\/script>`;
      })
    );
    return new Blob(parts, { type: "text/html" });
  }
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
        const file = await whole(
          shell,
          (done, all) => say(said, tr("{done} of {all}", { done, all }))
        );
        const name = location.pathname.split("/").pop()?.replace(/(\.html)?$/, ".html");
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
})();
