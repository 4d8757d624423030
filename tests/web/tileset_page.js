// A page that draws tileset.json with 3d-tiles-renderer until all that it wants is there; window.result says what.
import { DirectionalLight, PerspectiveCamera, Scene, Sphere, Vector3, WebGLRenderer } from 'three';
import { TilesRenderer } from '3d-tiles-renderer';

const parameters = new URLSearchParams(location.search);
const error = Number(parameters.get('error') ?? 16), near = Number(parameters.get('near') ?? 1);
const renderer = new WebGLRenderer({ preserveDrawingBuffer: true });
renderer.setSize(innerWidth, innerHeight);
renderer.setClearColor(0xff00ff);  // which no scene has
document.body.append(renderer.domElement);
const scene = new Scene(), camera = new PerspectiveCamera(50, innerWidth / innerHeight, 1, 1e5);
scene.add(new DirectionalLight());
const tiles = new TilesRenderer('/tileset.json');
const faults = [];
tiles.errorTarget = error;
tiles.addEventListener('load-error', (event) => faults.push(`${event.url}: ${event.error}`));
tiles.setCamera(camera);
tiles.setResolutionFromRenderer(camera, renderer);
scene.add(tiles.group);

// From the south-west, above.
function look(sphere) {
  const onEarth = sphere.center.length() > 6e6;
  const up = onEarth ? sphere.center.clone().normalize() : new Vector3(0, 0, 1);
  const east = onEarth ? new Vector3(0, 0, 1).cross(up).normalize() : new Vector3(1, 0, 0);
  const north = up.clone().cross(east);
  camera.up.copy(up);
  const along = (vector, share) => vector.clone().multiplyScalar(share * sphere.radius * 1.1 / near);
  camera.position.copy(sphere.center).add(along(up, 1.3)).add(along(north, -0.9)).add(along(east, -0.5));
  camera.lookAt(sphere.center);
  camera.far = 10 * sphere.radius;
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}

let quiet = 0;
function frame() {
  const sphere = new Sphere();
  if (tiles.getBoundingSphere(sphere)) look(sphere);
  tiles.update();
  renderer.render(scene, camera);
  const { downloading, parsing, queued = 0 } = tiles.stats;
  const busy = downloading + parsing + queued > 0 || tiles.visibleTiles.size === 0;
  quiet = busy ? 0 : quiet + 1;
  if (quiet < 20 && faults.length === 0) return requestAnimationFrame(frame);
  window.result = { faults, models: tiles.visibleTiles.size, triangles: renderer.info.render.triangles };
  document.body.dataset.drawn = 'yes';
}
frame();
