(function () {
  // This page stands at an address that is not there, at any depth: the nearest folder above it that
  // has our picture is the site. Plain old JavaScript, as it asks for no script of ours.
  var steps = location.pathname.split("/");
  function look(depth) {
    if (depth < 1) return; // whoever reads is told to go back
    var folder = steps.slice(0, depth).join("/");
    var root = location.protocol + "//" + location.host + folder + "/";
    var picture = new Image();
    picture.onload = function () {
      var home = document.getElementById("home");
      home.firstChild.href = root + "index.html";
      home.hidden = false;
    };
    picture.onerror = function () {
      look(depth - 1);
    };
    picture.src = root + "@@PICTURE@@";
  }
  look(steps.length - 1);
})();
