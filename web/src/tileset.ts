// Tiles that are tilesets of 3D Tiles: the finest models, with their images, as 3d-tiles-renderer reads them.
import { DownloadPriorityQueue, LRUCache, type Tile as Node } from '3d-tiles-renderer/core';
import { OBB, TilesRenderer } from '3d-tiles-renderer/three';
import { Box3, type Material, Matrix4, type Mesh, type Object3D, type Texture, Vector3 } from 'three';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { getTileIfThere, type TileFile } from './api';
import { sceneFrame, type Volume } from './earth';
import { type Focus, MOST_BYTES, type Surface, surfaceOf, type Tile } from './surface';

const HEIGHT = 1e5; // of what is in focus, metres above and below
const DOWNLOADS = 2; // at once: the coordinator reads a few tiles at once, for all pages

interface StoredNode { boundingVolume: Volume; transform?: number[]; children?: StoredNode[]; content?: object; contents?: object[] }
interface Tileset { root: StoredNode }

// The library reads `content` alone. Tilesets with several contents in a tile are no scenes of this program.
function withOneContent(node: StoredNode): void {
  node.content ??= node.contents?.[0];
  node.children?.forEach(withOneContent);
}

function parse(bytes: ArrayBuffer): Tileset {
  const tileset = JSON.parse(new TextDecoder().decode(bytes)) as Tileset;
  withOneContent(tileset.root);
  return tileset;
}

const NOTHING = new ArrayBuffer(0); // in place of a model that is not shown

// A plugin of the library: files come by the coordinator's routes alone, and all that is in focus is wanted at its finest.
class CellFiles {
  bytes = 0;
  missing = 0; // models
  left = 0;    // too much for one picture
  private readonly base: URL;
  private readonly tilesets = new Set<string>(); // the root is the first
  private readonly wanted: OBB | null;

  // `frame`: from that of the tileset to the scene.
  constructor(private readonly path: string, private readonly root: Tileset, focus: Focus | null, frame: Matrix4) {
    this.base = new URL(`${path}/`, location.href);
    this.wanted = focus && new OBB(new Box3(new Vector3(-focus.radius, -focus.radius, -HEIGHT), new Vector3(focus.radius, focus.radius, HEIGHT)),
      frame.clone().invert().multiply(new Matrix4().makeTranslation(focus.x, focus.y, 0)));
    this.wanted?.update();
  }

  get rootUrl(): string { return new URL('tileset.json', this.base).href; }

  async fetchData(url: string): Promise<Tileset | ArrayBuffer> {
    if (!this.tilesets.size) {
      this.tilesets.add('');
      return this.root;
    }
    const { origin, pathname } = new URL(url);
    const isInside = origin === this.base.origin && pathname.startsWith(this.base.pathname), isTileset = pathname.endsWith('.json');
    if (isTileset && this.tilesets.size === this.tilesets.add(pathname).size) throw new Error('Two tiles, or a tileset and itself, refer to one tileset.');
    if (!isTileset && this.bytes > MOST_BYTES) return this.without('left');
    const read = isInside ? await getTileIfThere(this.path, decodeURIComponent(pathname.slice(this.base.pathname.length))) : null;
    if (!read) return this.without('missing');
    if (isTileset) return parse(read.bytes);
    this.bytes += read.bytes.byteLength;
    return read.bytes;
  }

  private without(why: 'missing' | 'left'): ArrayBuffer {
    ++this[why];
    return NOTHING;
  }

  // The library reads what this does not.
  parseTile(content: unknown): Promise<void> | null { return content === NOTHING ? Promise.resolve() : null; }

  calculateTileViewError(tile: Node, target: { inView: boolean; error: number; distance: number }): true {
    const { boundingVolume } = (tile as Node & { engineData: { boundingVolume: { intersectsOBB(box: OBB): boolean } } }).engineData;
    target.inView = !this.wanted || boundingVolume.intersectsOBB(this.wanted);
    target.error = Infinity;
    target.distance = 0;
    return true;
  }
}

// The models of the tileset, in its frame, once all are there.
async function load(files: CellFiles): Promise<{ models: Object3D[]; failures: Error[] }> {
  // The decoder without WebAssembly, which the page's policy forbids; it is asked for when it is needed.
  const draco = new DRACOLoader().setDecoderPath('/').setDecoderConfig({ type: 'js' });
  const tiles = new TilesRenderer(files.rootUrl), failures: Error[] = [];
  tiles.manager.addHandler(/\.(gltf|glb)$/, new GLTFLoader().setDRACOLoader(draco));
  tiles.registerPlugin(files);
  tiles.lruCache = new LRUCache(); // the picture keeps what it shows, and nothing else does
  tiles.lruCache.minSize = tiles.lruCache.maxSize = tiles.lruCache.minBytesSize = tiles.lruCache.maxBytesSize = Infinity;
  tiles.lruCache.unloadPriorityCallback = () => 0;
  tiles.downloadQueue = new DownloadPriorityQueue();
  tiles.downloadQueue.maxJobsPerOrigin = DOWNLOADS;
  tiles.downloadQueue.priorityCallback = () => 0;
  tiles.loadAncestors = tiles.loadSiblings = false; // the finest alone
  tiles.maxTilesProcessed = Infinity;               // what waits for a later frame is not in the counts below
  const urls = new Map<Object3D, string>();
  tiles.addEventListener('load-model', ({ scene, url }) => urls.set(scene, String(url)));
  tiles.addEventListener('load-error', ({ error }) => failures.push(error));
  for (;;) {
    tiles.update();
    const { queued, downloading, parsing } = (tiles as unknown as { stats: Record<string, number> }).stats;
    if (tiles.root ? !queued && !downloading && !parsing : failures.length > 0) break;
    await new Promise((resolve) => { requestAnimationFrame(resolve); });
  }
  draco.dispose();
  const models = [...tiles.group.children].sort((a, b) => (urls.get(a)! < urls.get(b)! ? -1 : 1)); // else as they came
  return { models, failures };
}

const mapOf = (material: Material): Texture | null => (material as Material & { map?: Texture | null }).map ?? null;

// The meshes of a model; images get names of their own.
function surfacesOf(model: Object3D, toScene: Matrix4, textures: Map<string, Texture>): Surface[] {
  const surfaces: Surface[] = [];
  model.updateMatrixWorld(true);
  model.traverse((object) => {
    const mesh = object as Mesh;
    if (!mesh.isMesh) return;
    const map = mapOf(mesh.material as Material), surface = surfaceOf(mesh.geometry, map?.uuid ?? ''), point = new Vector3();
    if (map) textures.set(map.uuid, map);
    const matrix = toScene.clone().multiply(mesh.matrixWorld);
    for (let i = 0; i < surface.positions.length; i += 3) point.fromArray(surface.positions, i).applyMatrix4(matrix).toArray(surface.positions, i);
    surfaces.push(surface);
  });
  return surfaces;
}

// Why the tileset cannot be drawn.
function told(error: Error): Error {
  const coding = ['MESHOPT', 'KTX2'].find((name) => error.message.toUpperCase().includes(name));
  return coding ? new Error(`This page does not draw models that are compressed with ${coding}.`) : error;
}

// `frame`: that of the tile before, whose volume may have grown since.
export async function readTileset(path: string, file: TileFile, focus: Focus | null, frame: Matrix4 | null): Promise<Tile> {
  const tileset = parse(file.bytes), { root } = tileset;
  const transform = new Matrix4().fromArray(root.transform ?? new Matrix4().toArray());
  const toScene = frame ?? (file.frame ? new Matrix4().fromArray(file.frame) : sceneFrame(root.boundingVolume, transform));
  const files = new CellFiles(path, tileset, focus, toScene), { models, failures } = await load(files), { missing, left } = files;
  if (failures[0]) throw told(failures[0]);
  const textures = new Map<string, Texture>(), surfaces = models.flatMap((model) => surfacesOf(model, toScene, textures));
  const notes: string[] = [];
  if (left > 0) notes.push(`${left} of ${models.length + missing + left} models are not shown: choose a hole to see its surroundings.`);
  if (missing > 0) notes.push(`Models that are missing: ${missing}.`);
  return { surfaces, notes, frame: toScene, texture: async (image) => textures.get(image) ?? null };
}
