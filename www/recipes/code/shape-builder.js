import { Path } from "casteljau";

const circles = [
  [160, 80],
  [240, 80],
  [200, 140],
].map((center) => Path.circle(center, 70, { tolerance: 0.01 }));
const faces = Path.faces(circles);

const svg = document.querySelector("#shape-builder-picture");
const [group, outline] = svg.children;
const chosen = new Set();

function draw() {
  const shape = Path.combine(
    [...chosen].map((face) => face.path),
    "union",
  );
  outline.setAttribute("d", shape.toSVG());
  svg.nextElementSibling.textContent = `${chosen.size} of ${faces.length} faces, area ${Math.round(Math.abs(shape.area()))}`;
}

for (const face of faces) {
  const element = document.createElementNS(svg.namespaceURI, "path");
  const isIn = face.inside.map((inside, k) => (inside ? `circle ${k + 1}` : "")).filter(Boolean);
  const attributes = {
    d: face.path.toSVG(),
    class: "area",
    tabindex: 0,
    role: "checkbox",
    "aria-label": `Face in ${isIn.join(" and ")}`,
  };
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  const choose = (isChosen) => {
    if (isChosen) chosen.add(face);
    else chosen.delete(face);
    element.setAttribute("aria-checked", isChosen);
    element.classList.toggle("hit", isChosen);
    draw();
  };
  element.addEventListener("click", () => choose(!chosen.has(face)));
  element.addEventListener("keydown", (event) => {
    if (event.key !== " " && event.key !== "Enter") return;
    event.preventDefault();
    choose(!chosen.has(face));
  });
  group.append(element);
  choose(face.inside[0] && !face.inside[1]);
}
