function (number, data) {
  "use strict";
  var box = document.getElementById("motion" + number);
  var svg = box.querySelector("svg.moving");
  var controls = svg.nextElementSibling, readings = controls.nextElementSibling;
  var button = controls.children[0], slider = controls.children[1], output = controls.children[2];
  var lines = svg.querySelectorAll("polyline"), rounds = svg.querySelectorAll(":scope > g");
  var leaders = svg.querySelectorAll(":scope > path.leader");
  var last = data.t.length - 1, playing = 0, begun = 0, from = 0;
  box.classList.add("on");
  controls.style.display = readings.style.display = "flex";
  slider.max = last;
  function at(frames, i) { return frames[frames.length > 1 ? i : 0]; }
  function show(i) {
    data.l.forEach(function (frames, k) {
      var p = at(frames, i), text = "";
      for (var j = 0; j < p.length; j += 2) text += p[j] / 10 + "," + p[j + 1] / 10 + " ";
      lines[k].setAttribute("points", text);
      var letter = data.k[k] ? data.k[k][i] : "";
      if (letter && letter !== "-") lines[k].setAttribute("class", "line " + (letter === "s" ? "slack" : "t" + letter));
    });
    data.c.forEach(function (frames, k) {
      var c = at(frames, i);
      rounds[k].setAttribute("transform", "translate(" + c[0] / 10 + " " + c[1] / 10 + ")");
      rounds[k].children[1].setAttribute("transform", "rotate(" + c[2] + ")");
      var leader = leaders[k].getAttribute("d");
      if (leader) leaders[k].setAttribute("d", leader.split("L")[0] + "L" + c[0] / 10 + " " + c[1] / 10);
    });
    var now = data.t[i], happened = "";
    data.e.forEach(function (e) { if (e[0] <= now && e[0] > now - 0.08 * (data.t[last] - data.t[0])) happened = e[1]; });
    output.textContent = "t = " + now.toPrecision(4) + " s";
    readings.textContent = "";
    data.r.forEach(function (r) {
      var span = document.createElement("span");
      span.textContent = r[0] + " = " + r[2][i] + " " + r[1];
      readings.appendChild(span);
    });
    if (happened) {
      var bold = document.createElement("b");
      bold.textContent = happened;
      readings.appendChild(bold);
    }
    slider.value = i;
  }
  function stop() {
    cancelAnimationFrame(playing);
    playing = 0;
    button.textContent = "▶";
  }
  function step(clock) {
    if (!begun) begun = clock;
    var t = from + (clock - begun) / 1000, i = +slider.value;
    while (i < last && data.t[i + 1] <= t) ++i;
    if (i !== +slider.value) show(i);
    if (i >= last) return stop();
    playing = requestAnimationFrame(step);
  }
  button.onclick = function () {
    if (playing) return stop();
    if (+slider.value >= last) show(0);
    from = data.t[+slider.value];
    begun = 0;
    button.textContent = "❚❚";
    playing = requestAnimationFrame(step);
  };
  slider.oninput = function () { stop(); show(+slider.value); };
  show(0);
}
