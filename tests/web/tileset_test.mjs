// Reads made tilesets with web/src/tileset.ts, built as MODULE, as the page does: tileset_test.mjs MODULE
import assert from 'node:assert/strict';
import { pathToFileURL } from 'node:url';

const PATH = '/v1/jobs/1/cells/0,0/before';
globalThis.location = new URL('http://coordinator/');
globalThis.window = globalThis.self = globalThis;
globalThis.sessionStorage = { getItem: () => 'word' };
globalThis.requestAnimationFrame = (callback) => setTimeout(callback, 0);
globalThis.cancelAnimationFrame = clearTimeout;
let files = {}, asked = [];
globalThis.fetch = async (url, { headers }) => {
  const { origin, pathname, searchParams } = new URL(url, location);
  assert.equal(origin + pathname, `http://coordinator${PATH}`, 'another address is asked');
  assert.equal(headers.Authorization, 'Bearer word');
  const file = searchParams.get('path');
  asked.push(file);
  if (files[file]) return new Response(files[file]);
  return new Response(JSON.stringify({ error: { message: 'none', reason: 'TILE_NOT_FOUND' } }), { status: 404 });
};
const { readTileset } = await import(pathToFileURL(process.argv[2]).href);

// One triangle with a corner at x, 0, 0, y up.
function glb(x, more = {}) {
  const binary = Buffer.alloc(36);
  [x, 0, 0, x + 1, 0, 0, x, 0, -1].forEach((value, i) => binary.writeFloatLE(value, 4 * i));
  const document = { asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], buffers: [{ byteLength: 36 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }], bufferViews: [{ buffer: 0, byteLength: 36 }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [x, 0, -1], max: [x + 1, 0, 0] }], ...more };
  let text = JSON.stringify(document);
  text += ' '.repeat(-text.length & 3);
  const head = Buffer.alloc(20), middle = Buffer.alloc(8);
  head.write('glTF');
  [2, 28 + text.length + 36, text.length, 0x4e4f534a].forEach((value, i) => head.writeUInt32LE(value, 4 + 4 * i));
  [36, 0x004e4942].forEach((value, i) => middle.writeUInt32LE(value, 4 * i));
  return Buffer.concat([head, Buffer.from(text), middle, binary]);
}
const boxAt = (x) => ({ box: [x + 0.5, 0.5, 0, 0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5] });
const leaf = (x, uri) => ({ boundingVolume: boxAt(x), geometricError: 0, content: { uri } });
const tileset = (children, more = {}) => ({ asset: { version: '1.0' }, geometricError: 9, root: {
  boundingVolume: { box: [50, 0, 0, 60, 0, 0, 0, 60, 0, 0, 0, 60] }, geometricError: 5, refine: 'REPLACE', content: { uri: 'coarse.glb' }, children, ...more } });
async function read(root, focus = null) {
  asked = [];
  const bytes = new TextEncoder().encode(JSON.stringify(root)).buffer;
  const tile = await readTileset(PATH, { format: 'json', frame: null, bytes }, focus, null);
  return { ...tile, firsts: tile.surfaces.map(({ positions }) => [...positions.slice(0, 3)]) };
}

files = { 'a.glb': glb(0), 'sub/b.glb': glb(10), 'far.glb': glb(90), 'coarse.glb': glb(0),
  'sub/more.json': JSON.stringify(tileset([leaf(10, 'b.glb')])) };
const all = tileset([leaf(0, 'a.glb'), leaf(10, 'sub/more.json'), { ...leaf(90, ''), content: undefined, contents: [{ uri: 'far.glb' }] }],
  { transform: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 100, 0, 0, 1] });
const whole = await read(all);
assert.deepEqual(asked.sort(), ['a.glb', 'far.glb', 'sub/b.glb', 'sub/more.json'], 'the finest alone, each once');
assert.deepEqual(whole.firsts.map(([x]) => x).sort((a, b) => a - b), [100, 110, 190], 'moved by the transforms');
assert.deepEqual(whole.notes, []);
const turned = [...whole.surfaces.find(({ positions }) => positions[0] === 100).positions].map((value) => Math.round(value) + 0);
assert.deepEqual(turned, [100, 0, 0, 101, 0, 0, 100, 1, 0], 'y of a model is z of the scene');

const near = await read(all, { x: 100, y: 0, radius: 3 });
assert.deepEqual([asked, near.firsts.length], [['a.glb'], 1], 'what is not in focus is not asked for');

const gaps = await read(tileset([leaf(0, 'a.glb'), leaf(10, 'none.glb'), leaf(20, '../secret.glb'), leaf(30, 'http://elsewhere/x.glb'),
  leaf(40, '/v1/jobs')]));
assert.deepEqual(asked.sort(), ['a.glb', 'none.glb'], 'no path leads out of the cell');
assert.deepEqual([gaps.firsts.length, gaps.notes], [1, ['Models that are missing: 4.']]);

const meshopt = 'EXT_meshopt_compression', packed = { buffer: 0, byteLength: 36, byteStride: 12, count: 3, mode: 'ATTRIBUTES' };
files['packed.glb'] = glb(0, { extensionsUsed: [meshopt], extensionsRequired: [meshopt],
  bufferViews: [{ buffer: 0, byteLength: 36, extensions: { [meshopt]: packed } }] });
console.error = () => {};  // the library tells it as well
await assert.rejects(read(tileset([leaf(0, 'packed.glb')])), /does not draw models that are compressed with MESHOPT/);
process.exit(0);  // a timer of the library may be left
