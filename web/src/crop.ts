// Reads the surface around a fill: client/crop_bytes.h has the form.
import { BufferAttribute, BufferGeometry, Texture, SRGBColorSpace } from 'three';
import { gunzipSync } from 'three/addons/libs/fflate.module.js';
import { bytesOf } from './unzip';

export type Role = 'kept' | 'added' | 'cleared';
export interface Part { role: Role; geometry: BufferGeometry; texture: Texture | null }

export interface Crop {
  parts: Part[];
  remark?: string; // what is not shown
  centre: [number, number, number]; // of the fill, relative to the middle of the crop
  radius: number;                   // of the fill, metres
}

const linear = Float32Array.from({ length: 256 }, (_, i) => {
  const c = i / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
});

// An element, not a bitmap: the page's load event waits for elements.
function imageOf(jpeg: Uint8Array<ArrayBuffer>): Promise<HTMLImageElement> {
  return new Promise((resolve, reject) => {
    const image = new Image(), url = URL.createObjectURL(new Blob([jpeg], { type: 'image/jpeg' }));
    image.onload = () => {
      URL.revokeObjectURL(url);
      resolve(image);
    };
    image.onerror = () => {
      URL.revokeObjectURL(url);
      reject(new Error('its image cannot be read'));
    };
    image.src = url;
  });
}

async function textureOf(jpeg: Uint8Array<ArrayBuffer>): Promise<Texture | null> {
  if (jpeg.byteLength === 0) return null;
  const texture = new Texture(await imageOf(jpeg));
  texture.colorSpace = SRGBColorSpace;
  texture.flipY = false;
  texture.anisotropy = 8;
  texture.needsUpdate = true;
  return texture;
}

// Waits for nothing but the load event of its image. So pictures that are begun while the page is parsed are all there
// when the page is loaded, which is when a browser without a window prints it.
export async function readCrop(base64: string): Promise<Crop> {
  const bytes = gunzipSync(bytesOf(base64)), view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, false) !== 0x544d4331) throw new Error('not a picture'); // "TMC1"
  const [vertices, triangles, jpegBytes] = [4, 8, 12].map((at) => view.getUint32(at, true)) as [number, number, number];
  const bounds = Array.from({ length: 6 }, (_, i) => view.getFloat64(16 + 8 * i, true));
  let at = 64;
  const positions = new Float32Array(3 * vertices), places = new Float32Array(2 * vertices);
  const colours = new Float32Array(3 * vertices);
  for (let i = 0; i < 3 * vertices; ++i, at += 2) {
    const size = bounds[3 + i % 3]! - bounds[i % 3]!;
    positions[i] = (view.getUint16(at, true) / 65535 - 0.5) * size;
  }
  for (let i = 0; i < 2 * vertices; ++i, at += 2) places[i] = view.getUint16(at, true) / 65535;
  for (let i = 0; i < vertices; ++i, at += 4) {
    for (let k = 0; k < 3; ++k) colours[3 * i + k] = linear[view.getUint8(at + k)]!;
  }
  const states = bytes.subarray(at, at + triangles);
  at = Math.ceil((at + triangles) / 4) * 4;
  const corners: number[][] = [[], [], []];
  for (let t = 0; t < triangles; ++t, at += 12) {
    corners[states[t]!]!.push(view.getUint32(at, true), view.getUint32(at + 4, true), view.getUint32(at + 8, true));
  }
  const attributes = {
    position: new BufferAttribute(positions, 3), uv: new BufferAttribute(places, 2), color: new BufferAttribute(colours, 3) };
  const geometry = (index: number[]) => {
    const result = new BufferGeometry();
    for (const [name, attribute] of Object.entries(attributes)) result.setAttribute(name, attribute);
    result.setIndex(index);
    return result;
  };
  const [kept, added] = corners as [number[], number[], number[]];
  const texture = await textureOf(bytes.slice(at, at + jpegBytes));
  return {
    parts: (['kept', 'added', 'cleared'] as Role[]).map((role, i) => ({ role, geometry: geometry(corners[i]!), texture })),
    ...sphereOf(positions, added.length > 0 ? added : kept) };
}

export function sphereOf(positions: Float32Array, corners: ArrayLike<number>): { centre: [number, number, number]; radius: number } {
  const lo = [Infinity, Infinity, Infinity], hi = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < corners.length; ++i) {
    const v = corners[i]!;
    for (let k = 0; k < 3; ++k) {
      lo[k] = Math.min(lo[k]!, positions[3 * v + k]!);
      hi[k] = Math.max(hi[k]!, positions[3 * v + k]!);
    }
  }
  const centre = lo.map((low, k) => (low + hi[k]!) / 2) as [number, number, number];
  return { centre, radius: Math.max(1, Math.hypot(...lo.map((low, k) => hi[k]! - low)) / 2) };
}
