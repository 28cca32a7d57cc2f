import { InkStroke } from "casteljau";

const canvas = document.querySelector("#ink-picture");
const output = document.querySelector("output[for=ink-picture]");
const layers = [canvas, canvas.nextElementSibling];
const [drawing, preview] = layers.map((layer) => layer.getContext("2d"));
for (const context of [drawing, preview]) context.fillStyle = getComputedStyle(canvas).color;

canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  const pressure = event.pointerType === "pen" ? "device" : "simulated";
  const ink = new InkStroke({ size: 16, pressure });
  const { left, top, width } = canvas.getBoundingClientRect();
  const scale = canvas.width / width;
  const draw = (events) => {
    for (const { clientX, clientY, pressure, timeStamp: time } of events) {
      const [x, y] = [scale * (clientX - left), scale * (clientY - top)];
      ink.append(x, y, { pressure, time });
    }
    const { settled, open } = ink.changes();
    drawing.fill(settled.toPath2D());
    preview.clearRect(0, 0, canvas.width, canvas.height);
    preview.fill(open.toPath2D());
  };
  canvas.onpointermove = (event) => draw(event.getCoalescedEvents());
  canvas.onlostpointercapture = () => {
    output.textContent = `A stroke of ${ink.spline().segmentCount} curves`;
    canvas.onpointermove = null;
    drawing.drawImage(preview.canvas, 0, 0);
    preview.clearRect(0, 0, canvas.width, canvas.height);
  };
  draw([event]);
});
