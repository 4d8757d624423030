// OSGB files (OpenSceneGraph, versions 80 to 161), as common/codec/osgb reads them. What it does not know it refuses.
import { Cursor } from './osgb_cursor';

// What a PagedLOD shows, and the files that show it finer.
export interface PagedLod { centre: [number, number, number]; radius: number; files: string[] }

export interface OsgbGeometry {
  positions: Float32Array;        // three corners a triangle
  places: Float32Array | null;
  image: number;                  // -1: none
  lod: number;                    // the nearest above it; -1: none
}

export interface OsgbFile { geometries: OsgbGeometry[]; lods: PagedLod[]; images: (ArrayBuffer | null)[] }

const FIRST = 80, LAST = 161;
// Versions with which the format changed: common/codec/osgb/osgb_parse.h has their names.
const IMAGE_CLASS = 95, INSTANCES = 97, SWIZZLE = 98, ARRAY_OBJECTS = 112, DRAWABLE_MASK = 142, DRAWABLE_CULLING = 145,
  BUFFER_DATA = 147, LONG_BRACKETS = 149, DEFINES = 151, DRAWABLE_NODES = 154, TEXTURE_LEVELS = 155, DRAWABLE_NODES_ONLY = 156;

// Bytes of an element, in the order of the numbers of array types.
const ARRAYS: [string, number][] = [
  ['ByteArray', 1], ['UByteArray', 1], ['ShortArray', 2], ['UShortArray', 2], ['IntArray', 4], ['UIntArray', 4], ['FloatArray', 4],
  ['DoubleArray', 8], ['Vec2bArray', 2], ['Vec3bArray', 3], ['Vec4bArray', 4], ['Vec4ubArray', 4], ['Vec2sArray', 4], ['Vec3sArray', 6],
  ['Vec4sArray', 8], ['Vec2Array', 8], ['Vec3Array', 12], ['Vec4Array', 16], ['Vec2dArray', 16], ['Vec3dArray', 24], ['Vec4dArray', 32],
  ['Vec2ubArray', 2], ['Vec3ubArray', 3], ['Vec2usArray', 4], ['Vec3usArray', 6], ['Vec4usArray', 8], ['Vec2iArray', 8],
  ['Vec3iArray', 12], ['Vec4iArray', 16], ['Vec2uiArray', 8], ['Vec3uiArray', 12], ['Vec4uiArray', 16], ['UInt64Array', 8], ['Int64Array', 8]];
const VEC2 = 'Vec2Array', VEC3 = 'Vec3Array';

// Fields of attributes: b flag, i number, v four floats, d four doubles, o a number with a flag before it.
const ATTRIBUTES: Record<string, string> = { 'osg::Texture2D': 'oooooibbbbdiiooobiii', 'osg::ShadeModel': 'i', 'osg::CullFace': 'i',
  'osg::TexEnv': 'iv', 'osg::BlendFunc': 'iiii', 'osg::LightModel': 'vibb' };
const FIELD_BYTES: Record<string, number> = { b: 1, i: 4, o: 4, v: 16, d: 32 };

const TRIANGLES = 4, STRIP = 5, FAN = 6;
const PRIMITIVES = ['osg::DrawArrays', '', 'osg::DrawElementsUByte', 'osg::DrawElementsUShort', 'osg::DrawElementsUInt'], FIRST_PRIMITIVE = 50;

interface Values { type: string; bytes: ArrayBuffer }
interface Head { name: string; isDone: boolean; id: number }

function refuse(what: string): never { throw new Error(`An OSGB file with ${what || 'an unknown part'} is not drawn here.`); }

class Parser {
  readonly file: OsgbFile = { geometries: [], lods: [], images: [] };
  private readonly objects = new Map<number, unknown>(); // what they were read as
  private readonly arrays = new Map<number, Values>();   // by number, in older versions
  constructor(private readonly c: Cursor) {}

  header(): void {
    const { c } = this, magic = c.u32() === 0x6c910ea1 && c.u32() === 0x1afb4545;
    if (!magic || c.u32() !== 1) refuse('another beginning than that of a scene');
    c.version = c.u32();
    if (c.version < FIRST || c.version > LAST) refuse(`version ${c.version}`);
    const attributes = c.u32();
    if ((attributes & ~4) !== 0) refuse(`attributes ${attributes}`);
    if (c.text() !== '0') refuse('compression');
    if (attributes & 4) c.bracketBytes = c.version >= LONG_BRACKETS ? 8 : 4;
  }

  node(image: number, lod: number): void {
    const { c } = this, head = this.begin();
    if (head.name === 'NULL') return;
    if (head.isDone) refuse('a node with several parents');
    if (head.name === 'osg::Geometry') this.geometry(image, lod);
    else {
      this.objectFields();
      const own = this.nodeFields(image);
      switch (head.name) {
        case 'osg::Geode': this.geode(own, lod); break;
        case 'osg::Group': this.children(own, lod); break;
        case 'osg::PagedLOD': this.children(own, this.pagedLod()); break;
        case 'osg::MatrixTransform': this.transform(own, lod); break;
        default: refuse(head.name);
      }
    }
    this.objects.set(head.id, null);
  }

  private begin(): Head {
    const name = this.c.text();
    if (name === 'NULL') return { name, isDone: true, id: -1 };
    this.c.bracket();
    const id = this.c.u32();
    return { name, id, isDone: this.objects.has(id) };
  }

  private nothing(): void { if (this.c.flag()) refuse(this.c.text()); }

  private objectFields(): void {
    const { c } = this;
    c.text();
    c.u32();
    if (!c.flag()) return;
    const head = this.begin();
    if (head.isDone) return;
    if (head.name !== 'osg::DefaultUserDataContainer') refuse(head.name);
    this.objectFields();
    if (c.flag()) refuse('user data');
    if (c.flag()) { const count = c.u32(); c.bracket(); for (let k = 0; k < count; ++k) c.text(); }
    if (c.flag()) refuse('user objects');
    this.objects.set(head.id, null);
  }

  // The image of the node's state set, or the one from above.
  private nodeFields(image: number): number {
    const { c } = this;
    if (c.flag()) { c.bracket(); c.skip(32); }
    for (let k = 0; k < 4; ++k) this.nothing();
    c.flag();
    c.u32();
    return c.flag() ? this.stateSet(image) : image;
  }

  private children(image: number, lod: number): void {
    const { c } = this;
    if (!c.flag()) return;
    const count = c.u32();
    if (count > 0) c.bracket();
    for (let k = 0; k < count; ++k) this.node(image, lod);
  }

  private geode(image: number, lod: number): void {
    const { c } = this;
    if (!c.flag()) return;
    const count = c.u32();
    c.bracket();
    for (let k = 0; k < count; ++k) {
      const head = this.begin();
      if (head.name === 'NULL') continue;
      if (head.name !== 'osg::Geometry' || head.isDone) refuse(head.name);
      this.geometry(image, lod);
      this.objects.set(head.id, null);
    }
  }

  private pagedLod(): number {
    const { c } = this, lod: PagedLod = { centre: [0, 0, 0], radius: Infinity, files: [] };
    c.u32();
    if (c.flag()) { lod.centre = [c.f64(), c.f64(), c.f64()]; lod.radius = c.f64(); }
    c.u32();
    if (c.flag()) { const count = c.u32(); c.bracket(); c.skip(8 * count); }
    if (c.flag() && c.flag()) c.text();
    c.u32();
    c.flag();
    if (c.flag()) {
      const count = c.u32();
      c.bracket();
      for (let k = 0; k < count; ++k) { const name = c.text(); if (name) lod.files.push(name); }
      const priorities = c.u32();
      c.bracket();
      c.skip(8 * priorities);
    }
    return this.file.lods.push(lod) - 1;
  }

  private transform(image: number, lod: number): void {
    const { c, file } = this, [geometries, lods] = [file.geometries.length, file.lods.length];
    this.children(image, lod);
    if (c.u32() !== 0) refuse('a transform of another frame');
    c.bracket();
    const m = Array.from({ length: 16 }, () => c.f64());
    if (m.some((value, k) => k < 12 && value !== (k % 5 === 0 ? 1 : 0))) refuse('a transform that turns');
    for (const { positions } of file.geometries.slice(geometries)) for (let k = 0; k < positions.length; ++k) positions[k]! += m[12 + k % 3]!;
    for (const { centre } of file.lods.slice(lods)) for (let k = 0; k < 3; ++k) centre[k]! += m[12 + k]!;
  }

  private geometry(image: number, lod: number): void {
    const { c } = this;
    this.objectFields();
    const own = this.drawableFields(image), triangles: number[] = [], count = c.u32();
    for (let k = 0; k < count; ++k) this.primitives(triangles);
    const vertices = this.single();
    for (let k = 0; k < 4; ++k) this.single();
    const uv = this.list();
    this.list();
    if (c.version < ARRAY_OBJECTS) c.flag();
    if (!vertices || vertices.type !== VEC3) return;
    const pick = (from: Float32Array, size: number) => Float32Array.from({ length: size * triangles.length }, (_, k) =>
      from[size * triangles[Math.floor(k / size)]! + k % size]!);
    this.file.geometries.push({ positions: pick(new Float32Array(vertices.bytes), 3), image: own, lod,
      places: uv?.type === VEC2 ? pick(new Float32Array(uv.bytes), 2) : null });
  }

  private drawableFields(image: number): number {
    const { c } = this, { version } = c;
    let own = version >= DRAWABLE_NODES ? this.nodeFields(image) : image;
    if (version < DRAWABLE_NODES_ONLY && c.flag()) own = this.stateSet(own);
    if (c.flag()) { c.bracket(); c.skip(48); }
    this.nothing();
    this.nothing();
    c.skip(3);
    if (version < DRAWABLE_NODES_ONLY) for (let k = 0; k < 4; ++k) this.nothing();
    if (version >= DRAWABLE_MASK) c.u32();
    if (version >= DRAWABLE_CULLING) c.flag();
    return own;
  }

  private primitives(triangles: number[]): void {
    const { c } = this;
    let type = 0, mode = 0, id = -1;
    if (c.version < ARRAY_OBJECTS) {
      type = c.u32() - FIRST_PRIMITIVE;
      mode = c.u32();
      if (c.version >= INSTANCES) c.u32();
    } else {
      const head = this.begin();
      type = PRIMITIVES.indexOf(head.name);
      if (head.isDone || type < 0) refuse(head.name);
      id = head.id;
      this.objectFields();
      this.bufferData();
      c.u32();
      mode = c.u32();
    }
    if (!PRIMITIVES[type] || mode < TRIANGLES || mode > FAN) refuse(`primitives of type ${type} and mode ${mode}`);
    addTriangles(triangles, mode, this.indices(type));
    if (id >= 0) this.objects.set(id, null);
  }

  private indices(type: number): number[] {
    const { c } = this;
    if (type === 0) { const first = c.u32(); return Array.from({ length: c.u32() }, (_, k) => first + k); }
    const count = c.u32(), next = [() => c.u8(), () => c.u16(), () => c.u32()][type - 2]!;
    if (c.version < ARRAY_OBJECTS) c.bracket();
    const indices: number[] = [];
    for (let k = 0; k < count; ++k) indices.push(next());
    return indices;
  }

  private values(type: [string, number]): Values {
    const { c } = this, count = c.u32();
    if (c.version < ARRAY_OBJECTS) c.bracket();
    return { type: type[0], bytes: c.take(count * type[1]) };
  }

  private bound(): Values | null {
    const { c } = this;
    c.bracket();
    const array = c.flag() ? this.numbered() : null;
    if (c.flag()) refuse('vertex attributes by index');
    c.i32();
    c.u32();
    return array;
  }

  private numbered(): Values {
    const { c } = this, id = c.u32(), known = this.arrays.get(id);
    if (known) return known;
    const type = ARRAYS[c.u32()] ?? refuse('an array of an unknown type'), values = this.values(type);
    this.arrays.set(id, values);
    return values;
  }

  private arrayObject(): Values | null {
    const { c } = this, head = this.begin();
    if (head.name === 'NULL') return null;
    if (head.isDone) return this.objects.get(head.id) as Values;
    const type = ARRAYS.find(([name]) => head.name === `osg::${name}`) ?? refuse(head.name);
    this.objectFields();
    this.bufferData();
    c.i32();
    c.flag();
    c.flag();
    const values = this.values(type);
    this.objects.set(head.id, values);
    return values;
  }

  private bufferData(): void {
    const { c } = this;
    if (c.version < BUFFER_DATA || !c.flag()) return;
    const head = this.begin();
    if (head.isDone) return;
    this.objectFields();
    c.skip(8);
    c.flag();
    this.objects.set(head.id, null);
  }

  private single(): Values | null {
    if (!this.c.flag()) return null;
    return this.c.version < ARRAY_OBJECTS ? this.bound() : this.arrayObject();
  }

  // The first array of a list.
  private list(): Values | null {
    const { c } = this, isNumbered = c.version < ARRAY_OBJECTS;
    if (isNumbered && !c.flag()) return null;
    const count = c.u32();
    if (isNumbered) c.bracket();
    const arrays = Array.from({ length: count }, () => (isNumbered ? this.bound() : this.arrayObject()));
    return arrays[0] ?? null;
  }

  // The image of texture unit 0, or the one from above.
  private stateSet(image: number): number {
    const { c } = this, head = this.begin();
    if (head.isDone) return this.imageOr(this.objects.get(head.id), image);
    if (head.name !== 'osg::StateSet') refuse(head.name);
    this.objectFields();
    if (c.flag()) this.modes();
    if (c.flag()) this.attributes();
    if (c.flag()) { const units = c.u32(); c.bracket(); for (let k = 0; k < units; ++k) this.modes(); }
    let own = -1;
    if (c.flag()) {
      const units = c.u32();
      c.bracket();
      for (let k = 0; k < units; ++k) { const there = this.attributes(); if (k === 0) own = there; }
    }
    if (c.flag()) refuse('uniforms');
    c.skip(12);
    c.text();
    c.flag();
    this.nothing();
    this.nothing();
    if (c.version >= DEFINES && c.flag()) {
      const count = c.u32();
      c.bracket();
      for (let k = 0; k < count; ++k) { c.text(); c.text(); c.u32(); }
    }
    this.objects.set(head.id, own);
    return this.imageOr(own, image);
  }

  private imageOr(own: unknown, image: number): number { return typeof own === 'number' && own >= 0 ? own : image; }

  private modes(): void {
    const count = this.c.u32();
    if (count > 0) this.c.bracket();
    this.c.skip(8 * count);
  }

  // The image of a texture among them, or -1.
  private attributes(): number {
    const { c } = this, count = c.u32();
    if (count > 0) c.bracket();
    let image = -1;
    for (let k = 0; k < count; ++k) { image = Math.max(image, this.attribute()); c.u32(); }
    return image;
  }

  private attribute(): number {
    const { c } = this, head = this.begin();
    if (head.isDone) return (this.objects.get(head.id) as number | undefined) ?? -1;
    this.objectFields();
    this.nothing();
    this.nothing();
    let image = -1;
    const fields = ATTRIBUTES[head.name];
    if (head.name === 'osg::Material') this.material();
    else if (fields === undefined) refuse(head.name);
    else {
      for (const field of fields) if (field !== 'o' || c.flag()) c.skip(FIELD_BYTES[field]!);
      if (head.name === 'osg::Texture2D') image = this.texture();
    }
    this.objects.set(head.id, image);
    return image;
  }

  private material(): void {
    const { c } = this;
    c.u32();
    for (let k = 0; k < 4; ++k) if (c.flag()) c.skip(33);
    if (c.flag()) c.skip(9);
  }

  private texture(): number {
    const { c } = this;
    if (c.version >= IMAGE_CLASS && c.version < DRAWABLE_NODES && c.flag()) refuse('image attachments');
    if (c.version >= SWIZZLE && c.flag()) c.text();
    if (c.version >= TEXTURE_LEVELS) c.skip(12);
    const image = c.flag() ? this.image() : -1;
    c.skip(8);
    return image;
  }

  private image(): number {
    const { c } = this;
    if (c.version >= IMAGE_CLASS && c.text() !== 'osg::Image') refuse('an image of an unknown class');
    const id = c.u32();
    if (this.objects.has(id)) return this.objects.get(id) as number;
    c.text();
    c.u32();
    let bytes: ArrayBuffer | null = null;
    switch (c.u32()) {
      case 0: c.skip(36); c.skip(c.u32()); c.skip(4 * c.u32()); break; // pixels, which are not drawn
      case 1: bytes = c.take(c.u32()); break;
    }
    this.objectFields();
    const image = this.file.images.push(bytes) - 1;
    this.objects.set(id, image);
    return image;
  }
}

function addTriangles(triangles: number[], mode: number, indices: number[]): void {
  if (mode === TRIANGLES) {
    for (let k = 0; k + 3 <= indices.length; ++k) if (k % 3 === 0) triangles.push(indices[k]!, indices[k + 1]!, indices[k + 2]!);
    return;
  }
  for (let k = 0; k + 2 < indices.length; ++k) {
    const [a, b, d] = mode === FAN ? [0, k + 1, k + 2] : k % 2 === 0 || mode !== STRIP ? [k, k + 1, k + 2] : [k + 1, k, k + 2];
    triangles.push(indices[a]!, indices[b]!, indices[d]!);
  }
}

export function parseOsgb(bytes: ArrayBuffer): OsgbFile {
  const cursor = new Cursor(bytes), parser = new Parser(cursor);
  parser.header();
  parser.node(-1, -1);
  if (!cursor.isAtEnd) refuse('bytes behind its end');
  return parser.file;
}
