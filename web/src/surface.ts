// Surfaces as they are read from the files of a tile, in the coordinates of the scene.
import { type BufferGeometry, ClampToEdgeWrapping, type Matrix4, SRGBColorSpace, RepeatWrapping, Texture } from 'three';

// Three corners a triangle, in the order of the file.
export interface Surface {
  positions: Float32Array;
  places: Float32Array | null;   // on the image
  colours: Float32Array | null;
  image: string;                 // names the image among those of the tile; '': none
}

export interface Tile {
  surfaces: Surface[];
  texture: (image: string) => Promise<Texture | null>;
  notes: string[];               // what is not shown
  frame?: Matrix4;               // of a tileset: from that of its root's parent to the scene
}

// The part of the scene that is wanted: none is all of it.
export interface Focus { x: number; y: number; radius: number }

export const EMPTY: Tile = { surfaces: [], texture: async () => null, notes: [] };

// Of the corners from `start` on, `count` of them (all of the geometry if it has no index).
export function surfaceOf(geometry: BufferGeometry, image: string, start = 0, count = Infinity): Surface {
  const flat = geometry.index ? geometry.toNonIndexed() : geometry;
  const end = Math.min(flat.getAttribute('position').count, start + count);
  const numbers = (name: string, size: number): Float32Array | null => {
    const attribute = flat.getAttribute(name);
    if (!attribute) return null;
    const out = new Float32Array(size * (end - start));
    for (let i = start; i < end; ++i) {
      for (let k = 0; k < size; ++k) out[size * (i - start) + k] = attribute.getComponent(i, k);
    }
    return out;
  };
  return { positions: numbers('position', 3)!, places: numbers('uv', 2), colours: numbers('color', 3), image };
}

export const MOST_BYTES = 96 << 20; // of files of a tile in one picture
const MOST_PIXELS = 2048; // along a side: larger images are drawn smaller

// An image file for places whose v points up (OBJ, OSGB). `repeats`: beyond its borders it begins anew.
export async function textureOf(bytes: ArrayBuffer, repeats: boolean): Promise<Texture> {
  const blob = new Blob([bytes]), whole = await createImageBitmap(blob, { imageOrientation: 'flipY' });
  const scale = MOST_PIXELS / Math.max(whole.width, whole.height);
  const bitmap = scale >= 1 ? whole : await createImageBitmap(whole, {
    resizeWidth: Math.round(whole.width * scale), resizeHeight: Math.round(whole.height * scale), resizeQuality: 'medium' });
  const texture = new Texture(bitmap);
  texture.colorSpace = SRGBColorSpace;
  texture.flipY = false;
  texture.wrapS = texture.wrapT = repeats ? RepeatWrapping : ClampToEdgeWrapping;
  texture.anisotropy = 8;
  texture.needsUpdate = true;
  return texture;
}
