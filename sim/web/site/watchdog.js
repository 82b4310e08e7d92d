(function () {
  // Plain old JavaScript: it runs where our scripts do not, and says so. Nothing typed would be kept.
  var words = "@@WORDS@@";
  var page = document.documentElement;
  page.className += " carts-runs"; // style sheets close what waits for a run, only where scripts run
  var ours = /assets\/carts\/(answers|carts|class|measured)\.js/;
  // Where all cookies are blocked a browser throws when asked for this store, and the theme's scripts end
  // with it: no search, no dark colours. They get one that is empty and keeps nothing.
  function standIn(refused) {
    return {
      getItem: function () {
        return null;
      },
      setItem: function () {
        throw refused;
      },
      removeItem: function () {},
    };
  }
  try {
    window.localStorage.length;
  } catch (refused) {
    try {
      Object.defineProperty(window, "localStorage", { value: standIn(refused) });
    } catch (_) {
      // a browser that lets nobody replace it
    }
  }
  var failed = "";
  var loaded = false;
  var note = null;
  function say(text) {
    if (!note) {
      note = document.createElement("p");
      note.setAttribute("role", "alert");
      note.className = "carts-watchdog";
      note.style.cssText =
        "position:fixed;z-index:9999;left:0;right:0;top:0;margin:0;padding:0.8em 1em;" +
        "background:#b71c1c;color:#fff;font:bold 16px/1.4 sans-serif";
      document.body.insertBefore(note, document.body.firstChild);
    }
    note.textContent = text;
  }
  function look() {
    var scenes = document.querySelector("carts-scene, carts-map, carts-cost, carts-hard");
    var whole =
      failed !== "missing" &&
      page.hasAttribute("data-carts-answers") &&
      (!scenes || page.hasAttribute("data-carts-scenes"));
    var said = !whole ? failed || (loaded ? "broken" : "slow") : loaded && isPartial() ? "part" : "";
    if (!said && note) note.parentNode.removeChild(note);
    // There is no folder to copy on the web: the same is told in other words.
    if (said) say((/^http/.test(location.protocol) && words[said + " web"]) || words[said]);
    return whole;
  }
  function isPartial() {
    var waiting = document.querySelectorAll(":not(:defined)");
    for (var k = 0; k < waiting.length; k += 1) {
      if (waiting[k].nodeName.indexOf("CARTS-") === 0) return true;
    }
    return false;
  }
  function hear(event) {
    var script = event.target && event.target.src;
    if (script && ours.test(script)) failed = "missing";
  }
  // A style sheet that never comes holds back the whole page: it is asked for again, and waited for by nobody.
  // (Firefox goes on waiting for the first, until its own clock runs out: nothing but ending the page helps.)
  // A script that has just asked for one (teacher mode, formulas) waits for the first and hears of the second.
  function free() {
    var links = document.querySelectorAll('link[rel="stylesheet"]');
    for (var k = 0; k < links.length; k += 1) if (!links[k].sheet) replace(links[k]);
  }
  function replace(link) {
    var again = link.cloneNode(false);
    again.media = "print";
    again.onload = function () {
      again.onload = null; // another medium may load it once more
      again.media = link.media || "all";
      link.dispatchEvent(new Event("load"));
    };
    again.onerror = function () {
      link.dispatchEvent(new Event("error"));
    };
    link.parentNode.replaceChild(again, link);
  }
  window.addEventListener("error", hear, true);
  document.addEventListener("DOMContentLoaded", function () {
    loaded = true;
    look();
  });
  setTimeout(function () {
    free();
    if (!loaded && document.body) look();
  }, 3000);
})();
