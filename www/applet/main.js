// A table of coordinates beside the applet. This is all it takes to follow what the user does.
const rows = document.getElementById("rows");
const lastEvent = document.getElementById("event");

// A second call on the same canvas returns the same applet, so this script need not know which of the two came first.
window.addEventListener("load", () => {
  const app = bezierApp("beziercanvas");
  for (const type of ["input", "change"]) app.addEventListener(type, () => show(app, type)); // "input": while it moves
  show(app, "none yet");
});

function show(app, type) {
  rows.replaceChildren(...app.points.map((point, index) => row(point, index, index >= app.visiblePoints)));
  lastEvent.textContent = type;
}

function row([x, y], index, hidden) {
  const made = document.createElement("tr");
  made.append(cell("th", `P${index}`), cell("td", x.toFixed(1)), cell("td", y.toFixed(1)));
  made.className = hidden ? "hidden-point" : "";
  return made;
}

function cell(tag, text) {
  const made = document.createElement(tag);
  if (tag === "th") made.scope = "row";
  made.textContent = text;
  return made;
}
