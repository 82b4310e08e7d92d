"use strict";
(() => {
  // ../view/language.js
  var catalogue = globalThis.cartsWords ?? {};
  var RULE = catalogue["\0"] ?? "";
  function tr(sentence, values = {}) {
    return filled(catalogue[sentence] ?? sentence, values);
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole2, name) => String(values[name] ?? whole2));
  }

  // src/runtime/line.js
  var PAUSES = [1e3, 2e3, 4e3];
  var AT_ONCE = 2;
  var isOnWeb = () => /^https?:$/.test(globalThis.location?.protocol ?? "");
  var isFetching = () => isOnWeb() && !globalThis.__cartsInside;
  async function persistently(ask, pauses = isOnWeb() ? PAUSES : []) {
    for (const pause of pauses) {
      try {
        return await ask();
      } catch {
        await new Promise((resolve) => setTimeout(resolve, pause));
      }
    }
    return ask();
  }
  var Line = class {
    constructor(atOnce = isFetching() ? AT_ONCE : Number.POSITIVE_INFINITY) {
      this.free = atOnce;
      this.waiting = [];
    }
    async take(task) {
      if (this.free > 0) this.free -= 1;
      else await new Promise((resolve) => this.waiting.push(() => resolve(void 0)));
      try {
        return await task();
      } finally {
        const next = this.waiting.shift();
        if (next) next();
        else this.free += 1;
      }
    }
  };

  // src/shared/dom.js
  function html(tag, className = "", text = "") {
    const made = document.createElement(tag);
    if (className) made.className = className;
    if (text) made.textContent = text;
    return made;
  }
  var TEXT = 3;
  function say(element, text) {
    const only = element.firstChild;
    if (only?.nodeType === TEXT && !only.nextSibling) {
      if (only.nodeValue !== text) only.nodeValue = text;
    } else if (element.textContent !== text) element.textContent = text;
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

  // src/hosted/download.js
  var MARK = /<script data-from="([^"]+)"><.script>/;
  var textOf = (address) => persistently(async () => {
    const answer = await fetch(address, { cache: "no-cache" });
    if (!answer.ok) throw new Error(String(answer.status));
    return answer.text();
  });
  async function whole(shell, assets, tell) {
    const pieces = (await textOf(shell)).split(MARK);
    const line = new Line();
    let done = 0;
    const parts = await Promise.all(
      pieces.map(async (piece, k) => {
        if (k % 2 === 0) return piece;
        const text = await line.take(() => textOf(new URL(piece, assets)));
        done += 1;
        tell(done, (pieces.length - 1) / 2);
        return `<script>${text}<\/script>`;
      })
    );
    return new Blob(parts, { type: "text/html" });
  }
  function downloadLine(address, assets) {
    const line = document.createElement("p");
    const button2 = document.createElement("button");
    button2.type = "button";
    button2.className = "md-button";
    button2.textContent = tr("Download this lesson");
    const said = document.createElement("span");
    said.setAttribute("role", "status");
    said.textContent = tr("One file that opens by double click, without a network.");
    const shell = new URL(address, document.baseURI);
    button2.addEventListener("click", async () => {
      button2.disabled = true;
      try {
        const file = await whole(
          shell,
          assets,
          (done, all) => say(said, tr("{done} of {all}", { done, all }))
        );
        const name = decodeURIComponent(location.pathname).split("/").filter(Boolean).pop();
        downloadBlob((name ?? "lesson").replace(/(\.html)?$/, ".html"), file);
        say(said, tr("Saved: {size} MB.", { size: Math.ceil(file.size / 1e6) }));
      } catch {
        say(said, tr("The lesson could not be fetched. Try again with a network."));
      } finally {
        button2.disabled = false;
      }
    });
    line.append(button2, " ", said);
    return line;
  }

  // src/hosted/keep.js
  function keepLine(put) {
    if (window.top !== window) return;
    if (matchMedia("(display-mode: standalone)").matches) return;
    const how = byHand();
    if (how) {
      put(html("p", "carts-keep", `${tr("Keep this on your tablet:")} ${how}`));
      return;
    }
    addEventListener(
      "beforeinstallprompt",
      (event) => {
        event.preventDefault();
        put(button(event));
      },
      { once: true }
    );
  }
  function byHand() {
    const { userAgent, maxTouchPoints } = navigator;
    if (/iPad|iPhone/.test(userAgent) || /Macintosh/.test(userAgent) && maxTouchPoints > 1) {
      return tr("press Share, then Add to Home Screen. Then it opens without a network.");
    }
    if (/Android/.test(userAgent) && /Firefox/.test(userAgent)) {
      return tr("open the menu, then Add to Home screen. Then it opens without a network.");
    }
    return "";
  }
  function button(offer) {
    const line = html("p", "carts-keep");
    const press = html("button", "md-button", tr("Keep this on your tablet or computer"));
    press.setAttribute("type", "button");
    const said = html("span", "", tr("Then it opens without a network, like an app."));
    said.setAttribute("role", "status");
    press.addEventListener("click", async () => {
      const { outcome } = await offer.prompt();
      press.hidden = true;
      say(said, outcome === "accepted" ? tr("Kept.") : tr("The browser's own menu can do it too."));
    });
    line.append(press, " ", said);
    return line;
  }

  // src/hosted-main.js
  var { src } = document.currentScript;
  var place = document.querySelector(".carts-hosted");
  if (place) {
    const { shell } = place.dataset;
    if (shell) place.append(downloadLine(shell, new URL(".", src).href));
    if ("kept" in place.dataset) keepLine((line) => place.append(line));
  }
})();
