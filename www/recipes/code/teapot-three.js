import { Surface } from "casteljau";
import * as THREE from "three";

const canvas = document.querySelector("#teapot-three-picture");
const form = canvas.nextElementSibling;
const teapot = Surface.teapot({ up: "y" });

const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 200);
const body = new THREE.Mesh(
  undefined,
  new THREE.MeshStandardMaterial({
    color: 0x3b82c4,
    side: THREE.DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
  }),
);
const edges = new THREE.Mesh(
  undefined,
  new THREE.MeshBasicMaterial({ color: 0xffffff, wireframe: true, transparent: true, opacity: 0.4 }),
);
const light = new THREE.DirectionalLight(0xffffff, 2.5);
light.position.set(-3, 6, 5);
const scene = new THREE.Scene().add(body, edges, light, new THREE.AmbientLight(0xffffff, 1));

/** As many triangles as the distance needs: none is farther from the surface than so many pixels. */
function tessellate(pixels) {
  const viewProjection = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  return teapot.tessellate({ pixels, viewProjection, viewport: [canvas.width, canvas.height] });
}

function draw() {
  const { distance, pixels, wireframe } = form.elements;
  camera.position.set(0.3, 0.5, 1).setLength(Number(distance.value));
  camera.position.y += 1.5;
  camera.lookAt(0, 1.5, 0);
  camera.updateMatrixWorld();
  const mesh = tessellate(Number(pixels.value));
  body.geometry.dispose();
  body.geometry = edges.geometry = mesh.toThree(THREE);
  edges.visible = wireframe.checked;
  renderer.render(scene, camera);
  form.nextElementSibling.textContent = `${(mesh.indices.length / 3).toLocaleString("en")} triangles`;
}

new ResizeObserver(() => {
  if (!canvas.clientHeight) return; // not laid out yet
  renderer.setPixelRatio(devicePixelRatio);
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  camera.aspect = canvas.clientWidth / canvas.clientHeight;
  camera.updateProjectionMatrix();
  draw();
}).observe(canvas);
form.addEventListener("input", draw);
