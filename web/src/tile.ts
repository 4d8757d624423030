// A cell before and after, from the tiles' own files: what the output has beyond the input is new.
import { BufferAttribute, BufferGeometry, type Mesh } from 'three';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { ApiError, getTile } from './api';
import { type Crop, sphereOf } from './crop';
import type { Hole } from './data';

// Three corners a triangle, in the order of the file.
interface Soup { positions: Float32Array; colours: Float32Array | null }

function soupOf(geometries: BufferGeometry[]): Soup {
  const flat = geometries.map((g) => (g.index ? g.toNonIndexed() : g));
  const total = flat.reduce((sum, g) => sum + g.getAttribute('position').count, 0);
  const positions = new Float32Array(3 * total);
  const coloured = flat.every((g) => g.hasAttribute('color')), colours = coloured ? new Float32Array(3 * total) : null;
  let at = 0;
  for (const g of flat) {
    positions.set(g.getAttribute('position').array as Float32Array, at);
    colours?.set(g.getAttribute('color').array as Float32Array, at);
    at += 3 * g.getAttribute('position').count;
  }
  return { positions, colours };
}

const EMPTY: Soup = { positions: new Float32Array(), colours: null };

async function readTile(path: string): Promise<Soup> {
  try {
    const { format, bytes } = await getTile(path);
    if (format === 'ply') return soupOf([new PLYLoader().parse(bytes)]);
    if (format !== 'obj') throw new Error(`tiles of format .${format} are not drawn here; OBJ and PLY are`);
    const geometries: BufferGeometry[] = [];
    new OBJLoader().parse(new TextDecoder().decode(bytes)).traverse((object) => {
      if ((object as Mesh).isMesh) geometries.push((object as Mesh).geometry);
    });
    return soupOf(geometries);
  } catch (error) {
    if (error instanceof ApiError && error.reason === 'TILE_NOT_FOUND') return EMPTY;
    throw error;
  }
}

const keyOf = (p: Float32Array, i: number): string => p.subarray(i, i + 9).join();

// Triangles of `after` that `before` has not: [kept, added], as first numbers of their nine.
function divide(before: Soup, after: Soup): [number[], number[]] {
  const there = new Set<string>(), kept: number[] = [], added: number[] = [];
  for (let i = 0; i < before.positions.length; i += 9) there.add(keyOf(before.positions, i));
  for (let i = 0; i < after.positions.length; i += 9) (there.has(keyOf(after.positions, i)) ? kept : added).push(i);
  return [kept, added];
}

function middleOf(positions: Float32Array): [number, number, number] {
  const lo = [Infinity, Infinity, Infinity], hi = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    lo[i % 3] = Math.min(lo[i % 3]!, positions[i]!);
    hi[i % 3] = Math.max(hi[i % 3]!, positions[i]!);
  }
  return lo.map((low, k) => (Number.isFinite(low) ? (low + hi[k]!) / 2 : 0)) as [number, number, number];
}

function geometryOf(soup: Soup, starts: number[], middle: [number, number, number]): BufferGeometry {
  const positions = new Float32Array(9 * starts.length), colours = new Float32Array(9 * starts.length).fill(0.34);
  starts.forEach((start, t) => {
    for (let k = 0; k < 9; ++k) {
      positions[9 * t + k] = soup.positions[start + k]! - middle[k % 3]!;
      if (soup.colours) colours[9 * t + k] = soup.colours[start + k]!;
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('color', new BufferAttribute(colours, 3));
  return geometry;
}

// Of a cell, or of one hole in it.
export async function readCell(job: string, cell: [number, number], hole: Hole | null): Promise<Crop> {
  const path = `/v1/${job}/cells/${cell[0]},${cell[1]}`;
  const [before, after] = await Promise.all([readTile(`${path}/before`), readTile(`${path}/after`)]);
  const shown = after.positions.length > 0 ? after : before;
  if (shown.positions.length === 0) throw new Error('the cell has no surface yet');
  const [kept, added] = after.positions.length > 0 ? divide(before, after)
    : [Array.from({ length: before.positions.length / 9 }, (_, t) => 9 * t), []];
  const middle = middleOf(shown.positions);
  const geometries = {
    kept: geometryOf(shown, kept, middle), added: geometryOf(shown, added, middle), cleared: geometryOf(EMPTY, [], middle) };
  const focus = added.length > 0 && added.length < 20000 && !hole ? geometries.added : geometries.kept;
  const positions = (focus.getAttribute('position').count > 0 ? focus : geometries.added).getAttribute('position');
  const sphere = sphereOf(positions.array as Float32Array, Array.from({ length: positions.count }, (_, i) => i));
  if (hole && hole.centre.length >= 2) {
    const at = [0, 1, 2].map((k) => (hole.centre[k] ?? middle[k]!) - middle[k]!) as [number, number, number];
    return { geometries, texture: null, centre: at, radius: Math.max(2, Math.sqrt(hole.area)) };
  }
  return { geometries, texture: null, ...sphere };
}
