// Tiles that are trees of OSGB files: the finest geometry, with its images.
import { getTileIfThere } from './api';
import { type OsgbFile, parseOsgb } from './osgb';
import { type Focus, MOST_BYTES, type Surface, textureOf, type Tile } from './surface';

class Walk {
  readonly surfaces: Surface[] = [];
  readonly images = new Map<string, ArrayBuffer>();
  bytes = 0;
  left = 0;    // files that were not read
  missing = 0;
  private readonly seen = new Set<string>();

  constructor(private readonly path: string, private readonly focus: Focus | null, private readonly absent: Set<string>) {}

  // Takes what has no finer file; a missing one is made good by what is there.
  async take(file: OsgbFile, name: string): Promise<void> {
    const replaced = new Set<number>();
    for (const [k, { centre, radius, files }] of file.lods.entries()) {
      const { focus } = this;
      if (focus && Math.hypot(centre[0] - focus.x, centre[1] - focus.y) > radius + focus.radius) replaced.add(k);
      else if (files.length > 0 && await this.files(files)) replaced.add(k);
    }
    for (const { positions, places, image, lod } of file.geometries) {
      if (replaced.has(lod)) continue;
      const bytes = file.images[image], key = bytes ? `${name} ${image}` : '';
      if (bytes) this.images.set(key, bytes);
      this.surfaces.push({ positions, places, colours: null, image: key });
    }
  }

  private async files(names: string[]): Promise<boolean> {
    if (this.bytes > MOST_BYTES) {
      ++this.left;
      return false;
    }
    for (const name of names) {
      if (this.seen.has(name)) return false;
      this.seen.add(name);
      const read = this.absent.has(name) ? null : await getTileIfThere(this.path, name);
      if (!read) {
        if (this.path.endsWith('/before')) this.absent.add(name); // an output may not be complete yet
        ++this.missing;
        return false;
      }
      this.bytes += read.bytes.byteLength;
      await this.take(parseOsgb(read.bytes), name);
    }
    return true;
  }
}

// Files that tiles name and that are not there, by the tile in the scene. The output lacks them as well, as it has no
// finer file than the scene.
const MOST_ABSENT = 64; // tiles
const absentBy = new Map<string, Set<string>>();

function absentOf(path: string): Set<string> {
  const tile = path.replace(/\/(before|after)$/, ''), absent = absentBy.get(tile) ?? new Set<string>();
  if (absentBy.size >= MOST_ABSENT && !absentBy.has(tile)) absentBy.clear();
  absentBy.set(tile, absent);
  return absent;
}

export async function readOsgb(path: string, bytes: ArrayBuffer, focus: Focus | null): Promise<Tile> {
  const walk = new Walk(path, focus, absentOf(path)), notes: string[] = [];
  await walk.take(parseOsgb(bytes), '');
  if (walk.left > 0) notes.push('Parts of the tile are shown coarser: choose a hole to see its surroundings.');
  if (walk.missing > 0) notes.push(`${walk.missing === 1 ? '1 finer file that the tile names is' : `${walk.missing} finer files that the tile names are`} missing in the scene.`);
  return { surfaces: walk.surfaces, notes, texture: async (image) => {
    const jpeg = walk.images.get(image);
    return jpeg ? textureOf(jpeg, false) : null;
  } };
}
