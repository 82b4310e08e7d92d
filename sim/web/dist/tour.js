"use strict";
(() => {
  // ../view/language.js
  var catalogue = globalThis.cartsWords ?? {};
  var RULE = catalogue["\0"] ?? "";
  function tr(sentence, values = {}) {
    return filled(catalogue[sentence] ?? sentence, values);
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
  }

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
  function need(root, selector) {
    const found = root.querySelector(selector);
    if (!found) throw new Error(`this page lacks ${selector}; it was built by another version`);
    return found;
  }

  // src/shared/tab.js
  var TAB = () => sessionStorage;
  var BROWSER = () => localStorage;
  function recall(key, where = TAB) {
    try {
      return JSON.parse(where().getItem(key) ?? "null");
    } catch {
      return null;
    }
  }
  function retain(key, value, where = TAB) {
    try {
      where().setItem(key, JSON.stringify(value));
    } catch {
    }
  }

  // src/tour/hints.js
  var PULLED = ".carts-draggable";
  var HINTS = [
    {
      name: "drag",
      text: (scene) => pulled(scene)?.classList.contains("carts-cart") ? tr("Pull a cart: where shall it start?") : tr("Pull the arrow: how fast shall the cart start?"),
      place: pulled,
      can: (scene) => scene.time === 0 && scene.querySelector(".carts-panel input:enabled") !== null
    },
    {
      name: "play",
      text: () => tr("Press Play."),
      place: (scene) => scene.querySelector(".carts-play:enabled"),
      can: (scene) => scene.time === 0
    },
    {
      name: "back",
      text: () => tr("Pull the time back: you see it again."),
      place: (scene) => scene.querySelector(".carts-scrub:enabled"),
      can: (scene) => scene.time > 0
    }
  ];
  function pulled(scene) {
    const seen = [...scene.querySelectorAll(PULLED)].filter((part) => part.getClientRects().length);
    return seen.find((part) => part.classList.contains("carts-cart")) ?? seen[0] ?? null;
  }
  function isPulled(event) {
    return event.target instanceof Element && event.target.closest(PULLED) !== null;
  }

  // src/tour/tour.js
  var KEY = "carts-tour";
  var MOVING = ".carts-cart, .carts-velocity, .carts-acting";
  var HERE = "carts-tour-here";
  var REST = 150;
  var resting = 0;
  function showTour(scene) {
    const kept = recall(KEY, BROWSER);
    const done = new Set(Array.isArray(kept) ? kept : []);
    if (HINTS.every(({ name }) => done.has(name))) return;
    const card = html("div", "carts-tour");
    const text = html("span", "carts-tour-text");
    const close = html("button", "carts-tour-close", "×");
    close.setAttribute("type", "button");
    close.setAttribute("aria-label", tr("No more hints"));
    card.setAttribute("role", "note");
    card.append(text, close);
    const finish = (...names) => {
      if (names.every((name) => done.has(name))) return;
      for (const name of names) done.add(name);
      retain(KEY, [...done], BROWSER);
    };
    let before = 0;
    const look = () => {
      const playing = scene.querySelector(".carts-is-playing") !== null;
      if (playing) finish("play");
      else if (scene.time > 0 && scene.time < before) finish("back");
      before = scene.time;
      const busy = playing || scene.matches(".carts-asks, .carts-projector");
      point(scene, card, text, busy ? void 0 : nextHint(scene, done));
      if (done.size >= HINTS.length) end();
    };
    let asked = false;
    const soon = () => {
      if (asked) return;
      asked = true;
      requestAnimationFrame(() => {
        asked = false;
        look();
      });
    };
    const leaving = new AbortController();
    const options = { signal: leaving.signal, capture: true, passive: true };
    for (const kind of ["click", "input", "keyup", "pointerup", "carts-watched"]) {
      scene.addEventListener(kind, soon, options);
    }
    const pull = (event) => {
      if (isPulled(event)) finish("drag");
    };
    scene.addEventListener("pointerdown", pull, options);
    close.addEventListener("click", () => {
      finish(...HINTS.map(({ name }) => name));
      if (document.activeElement === close) need(scene, ".carts-play").focus();
      look();
    });
    const changes = new MutationObserver(soon);
    changes.observe(scene, {
      attributes: true,
      attributeFilter: ["class", "data-state", "disabled"],
      subtree: true
    });
    const end = () => {
      leaving.abort();
      changes.disconnect();
    };
    look();
  }
  function nextHint(scene, done) {
    return HINTS.find((hint) => !done.has(hint.name) && hint.place(scene) && hint.can(scene));
  }
  function point(scene, card, text, hint) {
    const place = hint?.place(scene);
    for (const old of scene.querySelectorAll(`.${HERE}`)) {
      if (old !== place) old.classList.remove(HERE);
    }
    const world = scene.querySelector(".carts-world");
    if (!hint || !place || !world) {
      card.remove();
      return;
    }
    const words = hint.text(scene);
    const isNew = card.parentElement !== world || text.textContent !== words;
    say(text, words);
    if (!place.classList.contains(HERE)) place.classList.add(HERE);
    if (card.parentElement !== world) world.append(card);
    clearTimeout(resting);
    if (isNew) settle(scene, card);
    else resting = setTimeout(settle, REST, scene, card);
  }
  function settle(scene, card) {
    const foot = scene.querySelector(".carts-world > p.carts-acting");
    card.style.setProperty("--foot", `${foot?.getBoundingClientRect().height ?? 0}px`);
    const under = ["", "end", "start", "low", "below"].map((at) => {
      card.dataset.at = at;
      return { at, count: covered(scene, card) };
    });
    const least = Math.min(...under.map(({ count }) => count));
    card.dataset.at = under.find(({ count }) => count === least)?.at;
  }
  function covered(scene, card) {
    const own = card.getBoundingClientRect();
    return [...scene.querySelectorAll(MOVING)].filter((part) => {
      const box = part.getBoundingClientRect();
      const beside = box.left >= own.right || box.right <= own.left;
      return box.width > 0 && !beside && box.top < own.bottom && box.bottom > own.top;
    }).length;
  }

  // src/tour-main.js
  var first = document.querySelector("carts-scene");
  if (first) showTour(first);
})();
