// A position in an OSGB file. Reads beyond its end throw a RangeError.

export class Cursor {
  version = 0;
  bracketBytes = 0; // of the sizes of brackets; 0: the file has none
  at = 0;
  private readonly view: DataView;

  constructor(private readonly bytes: ArrayBuffer) { this.view = new DataView(bytes); }

  get isAtEnd(): boolean { return this.at === this.bytes.byteLength; }
  u8(): number { return this.view.getUint8(this.skip(1)); }
  u16(): number { return this.view.getUint16(this.skip(2), true); }
  u32(): number { return this.view.getUint32(this.skip(4), true); }
  i32(): number { return this.view.getInt32(this.skip(4), true); }
  f32(): number { return this.view.getFloat32(this.skip(4), true); }
  f64(): number { return this.view.getFloat64(this.skip(8), true); }
  flag(): boolean { return this.u8() !== 0; }
  text(): string { return new TextDecoder().decode(this.take(this.u32())); }

  // The place before what was skipped.
  skip(count: number): number {
    const from = this.at;
    if (from + count > this.bytes.byteLength) throw new RangeError('an OSGB file ends too early');
    this.at += count;
    return from;
  }

  take(count: number): ArrayBuffer {
    const from = this.skip(count);
    return this.bytes.slice(from, from + count);
  }

  // A bracket that has its size at its beginning.
  bracket(): void { this.skip(this.bracketBytes); }
}
