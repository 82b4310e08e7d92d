"use strict";
(() => {
  // ../view/numbers.js
  function fixed(value, decimals) {
    const text = Math.abs(value).toFixed(decimals);
    return value < 0 && /[1-9]/.test(text) ? `−${text}` : text;
  }
  function px(value, decimals = 1) {
    const factor = 10 ** decimals;
    const rounded = Math.floor(value * factor + 0.5) / factor;
    return String(rounded === 0 ? 0 : rounded);
  }

  // src/shared/dom.js
  function put(element, name, value) {
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
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

  // src/shared/follow.js
  function followPointer(down, moved) {
    if (down.button > 0) return false;
    const leaving = new AbortController();
    const { signal } = leaving;
    const follow = (now) => {
      if (now.pointerId !== down.pointerId) return;
      if (now.buttons & 1) moved(now.clientX - down.clientX, now);
      else leaving.abort();
    };
    addEventListener("pointermove", follow, { signal });
    addEventListener("pointerup", follow, { signal });
    addEventListener("pointercancel", follow, { signal });
    return true;
  }

  // src/tools/ruler.js
  function workRuler(scene) {
    scene.addEventListener("input", ({ target }) => {
      if (target.closest('[data-tool="ruler"]')) lay(scene);
    });
    scene.addEventListener("pointerdown", (event) => {
      const end = event.target.closest(".carts-tape-end");
      if (end) pull(scene, end, event);
    });
  }
  function lay(scene) {
    const tool = need(scene, '[data-tool="ruler"]');
    const decimals = Number(tool.dataset.decimals);
    const slider = (key) => need(tool, `[data-end="${key}"]`);
    const [from, to] = [slider("from"), slider("to")];
    for (const one of [from, to]) {
      put(one, "aria-valuetext", `${fixed(one.valueAsNumber, decimals)} m`);
    }
    const length = fixed(Math.abs(to.valueAsNumber - from.valueAsNumber), decimals);
    say(need(tool, "output"), length);
    for (const tape of scene.querySelectorAll(".carts-tape")) {
      const { origin, scale, y } = tape.dataset;
      const at = (one) => Number(origin) + one.valueAsNumber * Number(scale);
      for (const one of [from, to]) {
        const end = need(tape, `[data-end="${one.dataset.end}"]`);
        put(end, "transform", `translate(${px(at(one))} 0)`);
      }
      put(need(tape, '[data-part="tape"]'), "d", `M${px(at(from))} ${y}H${px(at(to))}`);
      const text = need(tape, '[data-part="length"]');
      put(text, "x", px((at(from) + at(to)) / 2));
      say(text, `${length} m`);
    }
  }
  function pull(scene, end, down) {
    const tape = end.closest(".carts-tape");
    const stage = tape.ownerSVGElement;
    const key = end.getAttribute("data-end");
    const slider = need(scene, `[data-tool="ruler"] [data-end="${key}"]`);
    const { valueAsNumber: start } = slider;
    const units = stage.viewBox.baseVal.width / stage.getBoundingClientRect().width;
    const metres = units / Number(tape.dataset.scale);
    down.preventDefault();
    followPointer(down, (pixels) => {
      slider.valueAsNumber = start + pixels * metres;
      lay(scene);
    });
  }

  // src/tools/stopwatch.js
  var DECIMALS = 2;
  function workStopwatch(scene) {
    let counted = 0;
    let started = null;
    let here = need(scene, '[data-tool="stopwatch"]');
    const tool = () => {
      const now = need(scene, '[data-tool="stopwatch"]');
      if (now !== here) [here, counted, started] = [now, 0, null];
      return here;
    };
    const reading = () => counted + (started === null ? 0 : Math.max(0, scene.time - started));
    const show = () => {
      const button = need(tool(), '[data-act="stop"]');
      const read = need(here, "output");
      put(read, "aria-live", started === null ? "polite" : "off");
      say(read, fixed(reading(), DECIMALS));
      say(button, (started === null ? button.dataset.start : button.dataset.stop) ?? "");
    };
    const follow = () => {
      if (started === null || !scene.isConnected) return;
      show();
      requestAnimationFrame(follow);
    };
    scene.addEventListener("click", ({ target }) => {
      const button = target.closest('[data-tool="stopwatch"] [data-act]');
      if (!button) return;
      tool();
      if (button.getAttribute("data-act") === "zero") {
        counted = 0;
        if (started !== null) started = scene.time;
      } else if (started === null) {
        started = scene.time;
        follow();
      } else {
        counted = reading();
        started = null;
      }
      show();
    });
  }

  // src/tools-main.js
  for (const scene of document.querySelectorAll("carts-scene")) {
    const timed = scene;
    if (scene.querySelector('[data-tool="stopwatch"]')) workStopwatch(timed);
    if (scene.querySelector('[data-tool="ruler"]')) workRuler(timed);
  }
})();
