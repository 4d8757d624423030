// Tiles that are tilesets of 3D Tiles: the finest models, with their images.
import { type Material, Matrix4, type Mesh, type Texture, Vector3 } from 'three';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { getTile, getTileIfThere, type TileFile } from './api';
import { sceneFrame, type Volume } from './earth';
import { type Focus, MOST_BYTES, type Surface, surfaceOf, type Tile } from './surface';

interface Content { uri?: string; url?: string }
interface Node {
  boundingVolume: Volume; transform?: number[]; children?: Node[]; content?: Content; contents?: Content[]; implicitTiling?: unknown;
}
interface Tileset { asset?: { gltfUpAxis?: string }; root: Node }

interface Model { file: string; matrix: Matrix4; up: Matrix4 } // from z up to the scene; from the model to z up

const parse = (bytes: ArrayBuffer): Tileset => JSON.parse(new TextDecoder().decode(bytes)) as Tileset;
const folderOf = (file: string): string => file.slice(0, file.lastIndexOf('/') + 1);

// From the axes of a glTF model to z up.
function toZUp(axis: string): Matrix4 {
  switch (axis.toUpperCase()) {
    case 'Z': return new Matrix4();
    case 'X': return new Matrix4().set(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1);
    default: return new Matrix4().set(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
  }
}

// Whether nothing of a volume can be in focus. A region is taken to be.
function isOutside(volume: Volume, matrix: Matrix4, focus: Focus | null): boolean {
  const { box, sphere } = volume;
  if (!focus || (!box && !sphere)) return false;
  const middle = new Vector3().fromArray(box ?? sphere!).applyMatrix4(matrix);
  const half = box ? Math.hypot(...[3, 6, 9].map((k) => Math.hypot(box[k]!, box[k + 1]!, box[k + 2]!))) : sphere![3]!;
  return Math.hypot(middle.x - focus.x, middle.y - focus.y) > focus.radius + half * matrix.getMaxScaleOnAxis();
}

class Walk {
  readonly models: Model[] = [];
  private readonly seen = new Set<string>(); // tilesets that were read
  constructor(private readonly path: string, private readonly focus: Focus | null) {}

  async tileset({ asset, root }: Tileset, folder: string, outer: Matrix4): Promise<void> {
    await this.node(root, folder, outer, toZUp(asset?.gltfUpAxis ?? 'Y'));
  }

  // Refinement replaces what is coarser: the finest are those without children.
  private async node(node: Node, folder: string, outer: Matrix4, up: Matrix4): Promise<void> {
    if (node.implicitTiling) throw new Error('This page does not draw tilesets with implicit tiling.');
    const matrix = node.transform ? outer.clone().multiply(new Matrix4().fromArray(node.transform)) : outer;
    if (isOutside(node.boundingVolume, matrix, this.focus)) return;
    const uris = (node.contents ?? (node.content ? [node.content] : [])).map((c) => c.uri ?? c.url ?? '').filter(Boolean);
    const files = uris.map((uri) => folder + decodeURIComponent(uri.split('?')[0]!));
    for (const file of files.filter((name) => name.endsWith('.json') && !this.seen.has(name))) {
      this.seen.add(file);
      await this.tileset(parse((await getTile(this.path, file)).bytes), folderOf(file), matrix);
    }
    for (const child of node.children ?? []) await this.node(child, folder, matrix, up);
    if (node.children?.length) return;
    for (const file of files) {
      if (!file.endsWith('.json')) this.models.push({ file, matrix, up });
    }
  }
}

// The glTF in a model, and where its origin lies.
function unpack(bytes: ArrayBuffer): { gltf: ArrayBuffer; centre: number[] } {
  const view = new DataView(bytes), magic = new TextDecoder().decode(bytes.slice(0, 4));
  if (magic !== 'b3dm') return { gltf: bytes, centre: [0, 0, 0] };
  const [json, binary, batch, batchBinary] = [12, 16, 20, 24].map((at) => view.getUint32(at, true)) as [number, number, number, number];
  const table = json > 0 ? JSON.parse(new TextDecoder().decode(bytes.slice(28, 28 + json))) as { RTC_CENTER?: number[] | { byteOffset: number } } : {};
  const centre = table.RTC_CENTER ?? [0, 0, 0];
  return { gltf: bytes.slice(28 + json + binary + batch + batchBinary), centre: Array.isArray(centre) ? centre
    : [0, 4, 8].map((k) => view.getFloat32(28 + json + centre.byteOffset + k, true)) };
}

const mapOf = (material: Material): Texture | null => (material as Material & { map?: Texture | null }).map ?? null;

// Reads models; images get names of their own.
class Models {
  readonly textures = new Map<string, Texture>();
  // The decoder without WebAssembly, which the page's policy forbids; it is asked for when it is needed.
  private readonly draco = new DRACOLoader().setDecoderPath('/').setDecoderConfig({ type: 'js' });
  private readonly loader = new GLTFLoader().setDRACOLoader(this.draco);

  dispose(): void { this.draco.dispose(); }

  async read(bytes: ArrayBuffer, { matrix, up }: Model): Promise<Surface[]> {
    const { gltf, centre } = unpack(bytes), { scene } = await this.parse(gltf);
    const origin = matrix.clone().multiply(new Matrix4().makeTranslation(centre[0]!, centre[1]!, centre[2]!)).multiply(up);
    scene.updateMatrixWorld(true);
    const surfaces: Surface[] = [];
    scene.traverse((object) => {
      const mesh = object as Mesh;
      if (!mesh.isMesh) return;
      const surface = surfaceOf(mesh.geometry, this.nameOf(mesh.material as Material)), point = new Vector3();
      const toScene = origin.clone().multiply(mesh.matrixWorld);
      for (let i = 0; i < surface.positions.length; i += 3) point.fromArray(surface.positions, i).applyMatrix4(toScene).toArray(surface.positions, i);
      surfaces.push(surface);
    });
    return surfaces;
  }

  private nameOf(material: Material): string {
    const map = mapOf(material);
    if (map) this.textures.set(map.uuid, map);
    return map?.uuid ?? '';
  }

  private async parse(gltf: ArrayBuffer) {
    try {
      return await this.loader.parseAsync(gltf, '');
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      const coding = ['MESHOPT', 'KTX2'].find((name) => why.toUpperCase().includes(name));
      throw coding ? new Error(`This page does not draw models that are compressed with ${coding}.`) : error;
    }
  }
}

// Centres of models (RTC_CENTER) are in the frame of the tile, which has z up. `frame`: that of the tile before, whose
// volume may have grown since.
export async function readTileset(path: string, file: TileFile, focus: Focus | null, frame: Matrix4 | null): Promise<Tile> {
  const tileset = parse(file.bytes), { root } = tileset, walk = new Walk(path, focus), models = new Models();
  const transform = new Matrix4().fromArray(root.transform ?? new Matrix4().toArray());
  const toScene = frame ?? (file.frame ? new Matrix4().fromArray(file.frame) : sceneFrame(root.boundingVolume, transform));
  await walk.tileset(tileset, '', toScene);
  const surfaces: Surface[] = [], notes: string[] = [];
  let bytes = 0, missing = 0, left = walk.models.length;
  for (const model of walk.models) {
    if (bytes > MOST_BYTES) break;
    --left;
    const read = await getTileIfThere(path, model.file);
    if (!read) {
      ++missing;
      continue;
    }
    bytes += read.bytes.byteLength;
    surfaces.push(...await models.read(read.bytes, model));
  }
  models.dispose();
  if (left > 0) notes.push(`${left} of ${walk.models.length} models are not shown: choose a hole to see its surroundings.`);
  if (missing > 0) notes.push(`Models that are missing: ${missing}.`);
  return { surfaces, notes, frame: toScene, texture: async (image) => models.textures.get(image) ?? null };
}
