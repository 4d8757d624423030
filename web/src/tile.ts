// A cell before and after, from the tiles' own files: what the output has beyond the input is new.
import { BufferAttribute, BufferGeometry, type Matrix4, type Texture } from 'three';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { getTileIfThere } from './api';
import { type Crop, type Part, type Role, sphereOf } from './crop';
import type { Hole } from './data';
import { readObj } from './obj';
import { readOsgb } from './osgb_tile';
import { EMPTY, type Focus, type Surface, surfaceOf, type Tile } from './surface';
import { readTileset } from './tileset';
import { TriangleSet } from './triangle_set';

const SHOWN_AROUND = 6; // times the radius of a hole: what the picture shows when it is turned and zoomed out

async function readTile(path: string, focus: Focus | null, frame: Matrix4 | null = null): Promise<Tile & { format: string }> {
  const file = await getTileIfThere(path);
  switch (file?.format) {
    case undefined: return { ...EMPTY, format: '' };
    case 'ply': return { ...EMPTY, surfaces: [surfaceOf(new PLYLoader().parse(file!.bytes), '')], format: 'ply' };
    case 'obj': return { ...await readObj(path, file!.bytes), format: 'obj' };
    case 'json': return { ...await readTileset(path, file!, focus, frame), format: 'json' };
    case 'osgb': return { ...await readOsgb(path, file!.bytes, focus), format: 'osgb' };
    default: throw new Error(`This page does not draw tiles of format .${file!.format}. \`tilemend report OUT --html\` makes a page with pictures of them.`);
  }
}

// A surface cut to what is shown, with the first numbers of its triangles by their role.
interface Cut { surface: Surface; texture: Tile['texture']; starts: Map<Role, number[]> }

const isInside = (p: Float32Array, i: number, { x, y, radius }: Focus): boolean =>
  [0, 3, 6].some((k) => Math.hypot(p[i + k]! - x, p[i + k + 1]! - y) <= radius);

function setOf(tile: Tile): TriangleSet {
  const set = new TriangleSet(tile.surfaces.reduce((sum, { positions }) => sum + positions.length / 9, 0));
  for (const { positions } of tile.surfaces) set.add(positions);
  return set;
}

// The triangles of a tile: those that the other one has too are `same`.
function cutsOf(tile: Tile, other: TriangleSet | null, same: Role | null, own: Role, focus: Focus | null): Cut[] {
  return tile.surfaces.map((surface) => {
    const starts = new Map<Role, number[]>();
    for (let i = 0; i + 9 <= surface.positions.length; i += 9) {
      if (focus && !isInside(surface.positions, i, focus)) continue;
      const role = other?.has(surface.positions, i) ? same : own;
      if (!role) continue;
      const list = starts.get(role);
      if (list) list.push(i);
      else starts.set(role, [i]);
    }
    return { surface, texture: tile.texture, starts };
  });
}

function middleOf(cuts: Cut[]): [number, number, number] {
  const lo = [Infinity, Infinity, Infinity], hi = [-Infinity, -Infinity, -Infinity];
  for (const { surface, starts } of cuts) {
    for (const list of starts.values()) {
      for (const start of list) {
        for (let k = 0; k < 9; ++k) {
          lo[k % 3] = Math.min(lo[k % 3]!, surface.positions[start + k]!);
          hi[k % 3] = Math.max(hi[k % 3]!, surface.positions[start + k]!);
        }
      }
    }
  }
  return lo.map((low, k) => (Number.isFinite(low) ? (low + hi[k]!) / 2 : 0)) as [number, number, number];
}

// The height of the surface beside a place.
function heightAt(cuts: Cut[], { x, y }: Focus): number {
  let [best, height] = [Infinity, 0];
  for (const { surface: { positions: p }, starts } of cuts) {
    for (const start of [...starts.values()].flat()) {
      for (let i = start; i < start + 9; i += 3) {
        const distance = Math.hypot(p[i]! - x, p[i + 1]! - y);
        if (distance < best) [best, height] = [distance, p[i + 2]!];
      }
    }
  }
  return height;
}

const GREY = 0.34; // of what has neither image nor colour

function geometryOf(surface: Surface, starts: number[], middle: [number, number, number], isTextured: boolean): BufferGeometry {
  const geometry = new BufferGeometry();
  const pick = (from: Float32Array, size: number, change = (value: number, _: number) => value) => {
    const out = new Float32Array(3 * size * starts.length);
    starts.forEach((start, t) => {
      const first = start / 3 * size;
      for (let k = 0; k < 3 * size; ++k) out[3 * size * t + k] = change(from[first + k]!, k % size);
    });
    return new BufferAttribute(out, size);
  };
  geometry.setAttribute('position', pick(surface.positions, 3, (value, k) => value - middle[k]!));
  if (isTextured && surface.places) geometry.setAttribute('uv', pick(surface.places, 2));
  else if (surface.colours) geometry.setAttribute('color', pick(surface.colours, 3));
  else geometry.setAttribute('color', new BufferAttribute(new Float32Array(9 * starts.length).fill(GREY), 3));
  return geometry;
}

async function partsOf(cuts: Cut[], middle: [number, number, number]): Promise<Part[]> {
  const textures = new Map<string, Promise<Texture | null>>();
  const parts = cuts.flatMap(({ surface, texture, starts }) => [...starts].map(async ([role, list]): Promise<Part> => {
    const { image, places } = surface, key = `${role === 'cleared'} ${image}`;
    if (image && places && !textures.has(key)) textures.set(key, texture(image));
    const map = await (textures.get(key) ?? null);
    return { role, geometry: geometryOf(surface, list, middle, map !== null), texture: map };
  }));
  return Promise.all(parts);
}

// Of the added triangles, unless there are none or the whole cell is wanted because there are so many.
function sphereOfParts(parts: Part[]): { centre: [number, number, number]; radius: number } {
  const count = (role: Role) => parts.reduce((sum, part) => sum + (part.role === role ? part.geometry.getAttribute('position').count : 0), 0);
  const added = count('added'), role = added > 0 && (added < 60000 || count('kept') === 0) ? 'added' : 'kept';
  const chosen = parts.filter((part) => part.role === role), numbers = new Float32Array(3 * count(role));
  let at = 0;
  for (const { geometry } of chosen.length > 0 ? chosen : []) {
    const { array } = geometry.getAttribute('position');
    numbers.set(array as Float32Array, at);
    at += array.length;
  }
  return sphereOf(numbers, Array.from({ length: numbers.length / 3 }, (_, i) => i));
}

// The side of a square of its area; of one as long around where that is not known.
// That of a hole without area, such as a crack, is told by its rim.
const sizeOf = ({ area, rim }: Hole): number => (area ? Math.sqrt(area) : (rim ?? 0) / 4);

// Of a cell, or of one hole in it.
export async function readCell(job: string, cell: [number, number], hole: Hole | null): Promise<Crop> {
  const path = `/v1/${job}/cells/${cell[0]},${cell[1]}`;
  const radius = hole ? Math.max(2, sizeOf(hole)) : 0;
  const focus = hole && hole.centre.length >= 2 ? { x: hole.centre[0]!, y: hole.centre[1]!, radius: SHOWN_AROUND * radius } : null;
  const before = await readTile(`${path}/before`, focus), after = await readTile(`${path}/after`, focus, before.frame);
  const isWritten = after.surfaces.length > 0;
  if (!isWritten && before.surfaces.length === 0) throw new Error('the cell has no surface yet');
  const cuts = isWritten
    ? [...cutsOf(after, setOf(before), 'kept', 'added', focus), ...cutsOf(before, setOf(after), null, 'cleared', focus)]
    : cutsOf(before, null, null, 'kept', focus);
  const middle = middleOf(cuts), parts = await partsOf(cuts, middle);
  if (parts.length === 0) throw new Error('there is no surface here');
  const remark = [isWritten ? '' : 'The tile is not written yet.',
    isWritten && before.format && before.format !== after.format ? 'The output has another format, so all of it counts as new.' : '',
    ...new Set([...before.notes, ...after.notes])].filter(Boolean).join(' ');
  if (!focus) return { parts, remark, ...sphereOfParts(parts) };
  return { parts, remark, centre: [focus.x - middle[0], focus.y - middle[1], heightAt(cuts, focus) - middle[2]], radius };
}
