// Tiles in OBJ, with the materials and images that they name.
import type { Material, Mesh } from 'three';
import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { ApiError, getTile } from './api';
import { type Surface, surfaceOf, textureOf, type Tile } from './surface';

const text = (bytes: ArrayBuffer): string => new TextDecoder().decode(bytes);

// `from` names a file relative to the tile; what `from` names is relative to itself.
function beside(from: string, name: string): string {
  return from.slice(0, from.lastIndexOf('/') + 1) + name.replaceAll('\\', '/');
}

// The image of each material, by name; what could not be read goes to `notes`.
async function imagesOf(path: string, libraries: string[], notes: string[]): Promise<Map<string, string>> {
  const images = new Map<string, string>();
  for (const name of libraries) {
    const library = beside('', name);
    try {
      const creator = new MTLLoader().parse(text((await getTile(path, library)).bytes), '');
      for (const [material, info] of Object.entries(creator.materialsInfo)) {
        const image = info.map_kd ? creator.getTextureParams(info.map_kd, {}).url : '';
        if (image) images.set(material, beside(library, image));
      }
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      notes.push(`The material file ${library} cannot be read: ${error.message}.`);
    }
  }
  return images;
}

// One surface for each material of each object.
function surfacesOf(mesh: Mesh, images: Map<string, string>): Surface[] {
  const imageOf = (material: Material | undefined) => images.get(material?.name ?? '') ?? '';
  const { material, geometry } = mesh;
  if (!Array.isArray(material)) return [surfaceOf(geometry, imageOf(material))];
  return geometry.groups.map((group) => surfaceOf(geometry, imageOf(material[group.materialIndex ?? 0]), group.start, group.count));
}

export async function readObj(path: string, bytes: ArrayBuffer): Promise<Tile> {
  const group = new OBJLoader().parse(text(bytes)) as ReturnType<OBJLoader['parse']> & { materialLibraries: string[] };
  const notes: string[] = [], images = await imagesOf(path, group.materialLibraries, notes);
  const surfaces: Surface[] = [];
  group.traverse((object) => {
    if ((object as Mesh).isMesh) surfaces.push(...surfacesOf(object as Mesh, images));
  });
  const isBeyond = ({ places }: Surface) => places?.some((place) => place < 0 || place > 1) ?? false;
  const texture = async (image: string) => {
    const repeats = surfaces.some((surface) => surface.image === image && isBeyond(surface));
    try {
      return await textureOf((await getTile(path, image)).bytes, repeats);
    } catch {
      notes.push(`The image ${image} cannot be shown.`);
      return null;
    }
  };
  return { surfaces, texture, notes };
}
