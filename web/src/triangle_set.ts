// A set of triangles, each nine numbers that are compared bit by bit.

export class TriangleSet {
  private readonly heads: Int32Array;  // by hash: 1 + the last triangle that was added there
  private readonly links: Int32Array;  // by triangle: 1 + the one before it
  private readonly lists: { bits: Uint32Array; first: number }[] = [];
  private count = 0;

  constructor(most: number) {
    this.heads = new Int32Array(1 << Math.max(4, Math.ceil(Math.log2(most + 1))));
    this.links = new Int32Array(most);
  }

  // All triangles of the positions.
  add(positions: Float32Array): void {
    const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
    this.lists.push({ bits, first: this.count });
    for (let i = 0; i + 9 <= bits.length; i += 9) {
      const slot = this.slotOf(bits, i);
      this.links[this.count] = this.heads[slot]!;
      this.heads[slot] = ++this.count;
    }
  }

  // Whether it has the triangle whose numbers begin at `at`.
  has(positions: Float32Array, at: number): boolean {
    const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
    for (let k = this.heads[this.slotOf(bits, at)]!; k > 0; k = this.links[k - 1]!) {
      if (this.isSame(k - 1, bits, at)) return true;
    }
    return false;
  }

  private slotOf(bits: Uint32Array, at: number): number {
    let hash = 0;
    for (let k = 0; k < 9; ++k) {
      hash = Math.imul(hash ^ bits[at + k]!, 0x9e3779b1);
      hash ^= hash >>> 15;
    }
    return hash & (this.heads.length - 1);
  }

  private isSame(triangle: number, bits: Uint32Array, at: number): boolean {
    const list = this.lists.filter(({ first }) => first <= triangle).pop()!, from = 9 * (triangle - list.first);
    for (let k = 0; k < 9; ++k) if (list.bits[from + k] !== bits[at + k]) return false;
    return true;
  }
}
