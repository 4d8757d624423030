// A page that draws tileset.json with CesiumJS until all that it wants is there; window.result says what.
import {
  Cartesian3, Cesium3DTileset, CesiumWidget, Color, HeadingPitchRange, Math as Angles, Matrix4, SceneTransforms,
} from '@cesium/engine';

const parameters = new URLSearchParams(location.search);
const faults = [];

// A view without a globe: from the south-west, above.
function makeView() {
  const box = document.createElement('div');
  box.style = 'height:100vh';
  const style = document.createElement('style');
  style.textContent = '.cesium-widget, .cesium-widget canvas { width: 100%; height: 100% }';  // of its own style sheet
  document.body.append(style, box);
  const widget = new CesiumWidget(box, {
    baseLayer: false, globe: false, skyBox: false, skyAtmosphere: false, creditContainer: document.createElement('div'),
    contextOptions: { webgl: { preserveDrawingBuffer: true } } });
  widget.scene.backgroundColor = Color.fromBytes(255, 0, 255);  // which no scene has
  widget.scene.renderError.addEventListener((scene, error) => finish(scene, null, [`drawing: ${error}`]));
  return widget;
}

function finish(scene, tileset, more = []) {
  let models = 0, triangles = 0;
  for (const tile of tileset?._selectedTiles ?? []) {
    ++models;
    triangles += tile.content.trianglesLength;
  }
  const at = tileset && middleOnScreen(scene, tileset);
  window.result = { faults: [...faults, ...more], models, triangles, middle: at && [Math.round(at.x), Math.round(at.y)] };
  document.body.dataset.drawn = 'yes';
}

// The place of the scene's middle, `height` metres up, which is the zero of the root's frame.
function middleOnScreen(scene, tileset) {
  const height = Number(parameters.get('height') ?? 0);
  const point = Matrix4.multiplyByPoint(tileset.root.computedTransform, new Cartesian3(0, 0, height), new Cartesian3());
  return SceneTransforms.worldToWindowCoordinates(scene, point);
}

try {
  const widget = makeView();
  const tileset = await Cesium3DTileset.fromUrl('/tileset.json', {
    maximumScreenSpaceError: Number(parameters.get('error') ?? 16), skipLevelOfDetail: false });
  tileset.tileFailed.addEventListener(({ url, message }) => faults.push(`${url}: ${message}`));
  widget.scene.primitives.add(tileset);
  const view = new HeadingPitchRange(Angles.toRadians(30), Angles.toRadians(-50), 2.2 * tileset.boundingSphere.radius);
  widget.camera.viewBoundingSphere(tileset.boundingSphere, view);
  let quiet = 0;
  const stop = widget.scene.postRender.addEventListener(() => {
    quiet = tileset.tilesLoaded ? quiet + 1 : 0;
    if (quiet < 5 && faults.length === 0) return;
    stop();
    finish(widget.scene, tileset);
  });
} catch (error) {
  window.result = { faults: [`${error}`], models: 0, triangles: 0 };
  document.body.dataset.drawn = 'yes';
}
